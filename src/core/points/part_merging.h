// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/motion/motion_state.h"
#include "core/points/rigid_moments.h"

#include <vector>

namespace pcl_msf {

/** \brief Segments as one target pulls at them. */
struct MergeView {
  std::vector<RigidMoments> moments; ///< per segment
  std::vector<RigidPose> poses;      ///< per segment
  double variance{1.0};              ///< of a residual of weight 1
};

/** \brief Parts that move as one in all targets. */
struct MergedParts {
  std::vector<int> part_of;                  ///< per segment
  std::vector<std::vector<RigidPose>> poses; ///< per target and part, the best of its
                                             ///< moments
};

/** \brief Joins segments that move as one, the cheapest first: two parts merge when one
 * pose for both costs no more than their noise explains, in each of the targets.
 * \param views one or more, of the same segments */
MergedParts
mergeParts (const std::vector<MergeView>& views,
            const std::vector<SegmentLink>& links,
            const PointPartTuning& tuning);

} // namespace pcl_msf
