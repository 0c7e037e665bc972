// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <synthetic/scene_model.h>

#include <memory>

namespace pcl_msf::synthetic {

/** \brief Where a pixel's ray meets the scene; camera coordinates of its moment. */
struct ViewHit {
  int part{-1};             ///< -1 = nothing
  double depth{0.0};        ///< z, metres
  Eigen::Vector3d material; ///< surface coordinates; (u, v, 0) of a soft surface
  Eigen::Vector3d normal;   ///< unit length, towards the camera
  bool back{false};         ///< of a soft surface: its other side is seen

  Eigen::Vector3d
  point (const Eigen::Vector3d& direction) const
  {
    return depth * direction;
  }
};

/** \brief One part as the camera sees it at one moment. Thread-safe. */
class PartView {
public:
  virtual ~PartView() = default;

  /** \brief The nearest hit along a direction with z = 1, nearer than a limit. */
  virtual bool
  cast (const Eigen::Vector3d& direction, double limit, ViewHit& hit) const = 0;

  /** \brief Linear map from steps on the tangent plane in camera coordinates to
   * material coordinates. */
  virtual Eigen::Matrix3d
  materialFromCamera (const ViewHit& hit) const = 0;

  /** \brief Camera coordinates of a material point at this moment. */
  virtual Eigen::Vector3d
  place (const Eigen::Vector3d& material) const = 0;

  /** \brief The normal of phase 0 at a hit, in part coordinates: for shading. */
  virtual Eigen::Vector3d
  restNormal (const ViewHit& hit) const = 0;

  /** \brief Pixels that the part may cover, conservative. */
  virtual cv::Rect2d
  bounds () const = 0;
};

/** \brief A part's view at a phase.
 * \param camera_from_world at that phase */
std::unique_ptr<PartView>
makePartView (const Part& part,
              const Motion& world_from_body,
              const Isometry& camera_from_world,
              const PinholeCamera& camera,
              double phase);

/** \brief The view of a soft surface. \param camera_from_part at the phase */
std::unique_ptr<PartView>
makeSoftView (const SoftSurface& surface,
              const Isometry& camera_from_part,
              const PinholeCamera& camera,
              double phase);

/** \brief Pixels that a sphere may cover, conservative; everything when the camera is
 * in or beside it, nothing (empty) when it is behind. */
cv::Rect2d
sphereBounds (const Eigen::Vector3d& center,
              double radius,
              const PinholeCamera& camera);

} // namespace pcl_msf::synthetic
