// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/point_frame.h"

#include <vector>

namespace pcl_msf {

/** \brief The source's working points as parts. Lengths scaled. */
struct RigidParts {
  std::vector<int> part;                ///< per working point, the largest part first
  std::vector<RigidPose> poses;         ///< per part
  std::vector<Matrix6> information;     ///< per part, of the pose's parameters
  std::vector<int> sizes;               ///< per part, working points
  std::vector<Eigen::Vector3f> points;  ///< per working point, where it is moved to
  std::vector<Eigen::Vector3f> normals; ///< there
};

/** \brief Merges segments that move as one in all targets. A part that is large enough
 * for a body of its own moves rigidly up to its border, its motion fitted to all of its
 * points; on the rest of the surface motions blend. Given segments are rigid and stay
 * whole.
 * \param frames one or more, of the same source
 * \param merge false: every segment is a part
 * \return per frame: the same parts, in their order */
std::vector<RigidParts>
findParts (const std::vector<PointFrame>& frames,
           bool merge,
           const PointTuning& tuning,
           int threads);

} // namespace pcl_msf
