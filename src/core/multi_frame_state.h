// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief The unknowns of Eq. 13: poses per pair and body, weights shared by all pairs.
 *
 * All pairs have the same bodies. */
struct MultiFrameState {
  std::vector<int> body_of;                  ///< per segment
  std::vector<std::vector<RigidPose>> poses; ///< per pair, per body
  std::vector<double> weights;               ///< per link

  int
  bodies () const
  {
    return poses.empty() ? 0 : static_cast<int> (poses[0].size());
  }

  /** \brief One pair's share, as the two-frame parts take it. */
  MotionState
  ofPair (int pair) const
  {
    return {body_of, poses[pair], weights};
  }
};

} // namespace pcl_msf
