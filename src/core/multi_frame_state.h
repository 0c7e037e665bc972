// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/motion_state.h"

#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief The unknowns of Eq. 13: poses per pair and body, weights shared by all pairs.
 *
 * All pairs have the same bodies. Two frames are a window of one pair. */
struct MultiFrameState {
  std::vector<int> body_of;                  ///< per segment
  std::vector<std::vector<RigidPose>> poses; ///< per pair, per body
  std::vector<double> weights;               ///< per link

  MultiFrameState() = default;

  /** \brief The window of one pair. */
  explicit MultiFrameState (MotionState state)
  : body_of (std::move (state.body_of))
  , poses{std::move (state.poses)}
  , weights (std::move (state.weights))
  {}

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

  /** \brief Bodies without segments disappear; the others are numbered in the order of
   * the segments. \return what they were before */
  std::vector<int>
  renumberBodies ();
};

} // namespace pcl_msf
