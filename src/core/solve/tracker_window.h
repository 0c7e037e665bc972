// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/scene_flow_tracker.h>

#include <deque>
#include <vector>

namespace pcl_msf {

/** What is solved next. */
struct SceneFlowTracker::Window {
  std::deque<RgbdFrame> frames;
  std::vector<long> indices; ///< per frame
  std::vector<int>
      former; ///< per frame but the new one, its place in the former window
  Oversegmentation segments;
  std::vector<int> origin; ///< per segment, its number in the former window or -1
  RigidPose world_from_reference;
};

} // namespace pcl_msf
