// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <memory>

namespace pcl_msf::synthetic {

/** \brief What form a soft surface has at one moment. Thread-safe. */
class SoftForm {
public:
  virtual ~SoftForm() = default;

  /** \brief Body coordinates of the material point (u, v), metres. Smooth, also a
   * little beyond the surface's edges. */
  virtual Eigen::Vector3d
  place (double u, double v) const = 0;
};

/** \brief A surface that changes its form: a smooth map from a rectangle of material
 * coordinates (u, v) in metres and time to space. Thread-safe. */
class SoftSurface {
public:
  virtual ~SoftSurface() = default;

  /** \param phase time in the units of the scene's motion; 0 = frame 0 */
  virtual std::unique_ptr<SoftForm>
  formAt (double phase) const = 0;

  /** \brief Half sizes of the rectangle in u and v, metres. */
  virtual Eigen::Vector2d
  halfSize () const = 0;
};

using SoftSurfacePtr = std::shared_ptr<const SoftSurface>;

/** \brief A hanging sheet that bends around a moving axis, twists, and ripples.
 * \param start where in its swing phase 0 is, radians, (-1, 1) */
SoftSurfacePtr
makeBendingSheet (const Eigen::Vector2d& half, double start);

/** \brief The front of a torso that swells and sinks in several places at once. */
SoftSurfacePtr
makeBreathingTorso (const Eigen::Vector2d& half, double start);

} // namespace pcl_msf::synthetic
