// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include "core/data/data_term.h"
#include "core/data/surface_sample.h"

#include <cmath>

namespace pcl_msf {

/** \brief A point's residuals (Eq. 6 and 8) where the frame shows it, in standard
 * deviations; 0 where the point has no such residual. */
struct PointResiduals {
  ImagePlace at;          ///< where it appears
  float brightness{0.0f}; ///< frame minus reference
  float icp{0.0f};        ///< distance from the frame's plane
};

/** \brief Some of a DataTerm's points. */
struct PointRange {
  int begin;
  int end;
  int step{1};
};

/** \brief Calls f (point, residuals) for each point of a range that a pose takes onto
 * the frame's surface. */
template <typename F>
void
forEachSeen (const DataTerm& data,
             const RigidPose& pose,
             const PointRange& range,
             const F& f)
{
  const SegmentPixels& p = data.pixels();
  const kernel::Image image = data.image();
  const Eigen::Matrix3f r = pose.rotation().cast<float>();
  const Eigen::Vector3f t = pose.translation().cast<float>();
  for (int i = range.begin; i < range.end; i += range.step) {
    const Eigen::Vector3f q = r * Eigen::Vector3f (p.x[i], p.y[i], p.z[i]) + t;
    if (!(q.z() > 1e-3f))
      continue;
    PointResiduals residuals;
    residuals.at = projectTo (image, q);
    const ImagePlace& at = residuals.at;
    if (!isBetweenPixels (image, at))
      continue;
    const float seen = inverseDepthAt (image, at);
    if (!isOnSurface (seen, q.z(), p.depth_tolerance[i]))
      continue;
    const Eigen::Vector3f n = r * Eigen::Vector3f (p.nx[i], p.ny[i], p.nz[i]);
    residuals.brightness =
        (intensityAt (image, at) - p.intensity[i]) * p.brightness_scale[i];
    residuals.icp = planeDistance (q, n, seen) * p.icp_scale[i];
    f (i, residuals);
  }
}

} // namespace pcl_msf
