// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/points/deformation.h"
#include "core/points/isometry.h"
#include <pcl_msf/rigid_pose.h>

#include <vector>

namespace pcl_msf {

/** \brief The rigid motion of weighted pairs of points, as columns: Kabsch's, robust
 * against pairs that are off by more than `scale`. */
RigidPose
fitPairs (const Eigen::Matrix3Xd& from,
          const Eigen::Matrix3Xd& to,
          const std::vector<double>& weights,
          double scale,
          const LimbTuning& tuning);

/** \brief Every segment's motion by the pairs that it and its overlap hold; segments
 * with hardly any keep theirs.
 * \param pairs of a sample and a point of the target \param poses per segment */
void
startSegments (const PointSamples& samples,
               const std::vector<Eigen::Vector3f>& target,
               const std::vector<PointPair>& pairs,
               double scale,
               const LimbTuning& tuning,
               std::vector<RigidPose>& poses);

} // namespace pcl_msf
