// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/window_level.h"
#include "core/motion/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief What an earlier frame told about the reference's motions, for a later one. */
struct FollowedMotion {
  std::vector<int> body_of; ///< per segment
  /** Per guess, per body: where each may be. The best one is taken. */
  std::vector<std::vector<RigidPose>> guesses;
  std::vector<SegmentLink> links; ///< empty: not known yet
  CorrelationAreas areas;         ///< of that frame's residuals
  double brightness_area{1.0};    ///< see WindowScene
  std::vector<double> costs;      ///< per segment, see WindowSolve::fit ()
  cv::Mat depth; ///< of the reference, with what other frames measured; see DepthFusion
};

} // namespace pcl_msf
