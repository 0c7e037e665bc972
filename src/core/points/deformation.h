// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/surface/surface_segments.h"
#include <pcl_msf/rigid_pose.h>

#include <vector>

namespace pcl_msf {

/** \brief Points that follow segments: a sample of a surface. */
struct PointSamples {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals;
  std::vector<std::vector<Membership>> members;
  std::vector<float> brightness; ///< NaN = unknown; may be empty

  int
  size () const
  {
    return static_cast<int> (points.size());
  }
};

/** \brief Moved points. */
struct MovedPoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals;
  std::vector<float> brightness; ///< as before
};

/** \brief Each point moved by the mean of its segments' motions. */
MovedPoints
movePoints (const PointSamples& samples,
            const std::vector<RigidPose>& poses,
            int threads);

} // namespace pcl_msf
