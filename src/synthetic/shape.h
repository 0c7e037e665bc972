// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <memory>

namespace pcl_msf::synthetic {

/** \brief Half line origin + s direction, s > 0; the direction needs no unit length. */
struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;

  Eigen::Vector3d
  at (double s) const
  {
    return origin + s * direction;
  }
};

/** \brief Where a ray meets a surface. */
struct ShapeHit {
  double s{0.0};
  Eigen::Vector3d normal; ///< unit length, towards the ray's origin
};

/** \brief A rigid surface in its own coordinates, which are its material's, metres.
 * Thread-safe. */
class Shape {
public:
  virtual ~Shape() = default;

  /** \brief The nearest intersection with 0 < s < limit, if there is one. */
  virtual bool
  intersect (const Ray& ray, double limit, ShapeHit& hit) const = 0;

  /** \brief Radius of a sphere around the origin that holds the shape, metres. */
  virtual double
  radius () const = 0;
};

using ShapePtr = std::shared_ptr<const Shape>;

/** \brief Box around the origin, seen from outside. \param half half sizes, metres */
ShapePtr
makeBox (const Eigen::Vector3d& half);

/** \brief Box around the origin, seen from inside: a room. */
ShapePtr
makeRoom (const Eigen::Vector3d& half);

/** \brief Ellipsoid around the origin. \param axes half axes, metres */
ShapePtr
makeEllipsoid (const Eigen::Vector3d& axes);

/** \brief Cylinder with round ends around the segment from the origin to (0, 0,
 * length). */
ShapePtr
makeCapsule (double length, double radius);

/** \brief Cylinder with flat ends around the origin, axis z. */
ShapePtr
makeCylinder (double half_length, double radius);

} // namespace pcl_msf::synthetic
