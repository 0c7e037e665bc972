// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/joint_solver.h"
#include "core/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief Lets segments jump to other poses where descent cannot take them.
 *
 * Each segment tries its own candidates, the common ones and its neighbours' present
 * poses, and takes the one with the lowest share of the energy (truncated data cost of
 * sampled points plus coupling at the best weights). All decide at once on the last
 * round's state, so that the outcome does not depend on the order.
 */
class PoseProposals {
public:
  PoseProposals (JointEnergy& energy,
                 const std::vector<SegmentLink>& links,
                 int threads);

  void
  addCommon (const RigidPose& pose)
  {
    common_.push_back (pose);
  }
  void
  addOwn (int segment, const RigidPose& pose)
  {
    own_[segment].push_back (pose);
  }

  /** \brief Runs rounds until nobody moves. The state must have one body per segment.
   * \return how many changes were made */
  int
  run (int rounds, MotionState& state);

private:
  struct Neighbor {
    int segment;
    int link;
  };

  double
  cost (int segment, const RigidPose& pose, const MotionState& state) const;
  void
  lookWhoIsSeen (const MotionState& state);
  bool
  improve (int segment, const MotionState& state, bool first, RigidPose& pose) const;

  JointEnergy& energy_;
  int threads_;
  std::vector<std::vector<Neighbor>> neighbors_;
  std::vector<std::vector<RigidPose>> own_;
  std::vector<RigidPose> common_;
  std::vector<UnpackedPose> present_; ///< poses of the round's state
  std::vector<char> seen_; ///< per segment: mostly visible at its present pose
};

} // namespace pcl_msf
