// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/motion/motion_state.h"
#include "core/points/rigid_moments.h"

#include <vector>

namespace pcl_msf {

/** \brief Parts that move as one. */
struct MergedParts {
  std::vector<int> part_of;          ///< per segment
  std::vector<RigidMoments> moments; ///< per part
  std::vector<RigidPose> poses;      ///< per part, the best of its moments
};

/** \brief Joins segments that move as one, the cheapest first: two parts merge when one
 * pose for both costs no more than their noise explains.
 * \param moments, poses per segment \param variance of a residual of weight 1 */
MergedParts
mergeParts (const std::vector<RigidMoments>& moments,
            const std::vector<RigidPose>& poses,
            const std::vector<SegmentLink>& links,
            double variance,
            const PointPartTuning& tuning);

} // namespace pcl_msf
