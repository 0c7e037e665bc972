// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/start_tuning.h"
#include "core/data/data_term.h"
#include "core/motion/motion_state.h"
#include <pcl_msf/parameters.h>

#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief Changes segments' poses to others that descent does not reach.
 *
 * Each segment tries its own candidates, the common ones and its neighbours' present
 * poses, and takes the one with the lowest share of the energy (truncated data cost of
 * sampled points plus coupling at the best weights). All change at once, by the last
 * round's state, so that the outcome does not depend on the order.
 */
class PoseProposals {
public:
  /** \param probes sampled points of a level \param focal_length of the level, pixels
   */
  PoseProposals (const DataTerm& probes,
                 const std::vector<SegmentLink>& links,
                 const EnergyParameters& energy,
                 double focal_length,
                 const ProposalTuning& tuning,
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

  /** \brief Weighs optical flow, too. \param residuals that it is worth, a segment
   */
  void
  weighFlow (double residuals)
  {
    flow_worth_ = residuals;
  }

  /** \brief Only these segments change; all may by default. */
  void
  restrictTo (std::vector<char> segments)
  {
    moving_ = std::move (segments);
  }

  /** \brief Runs rounds until none changes. \param poses per segment
   * \return how many changes were made */
  int
  run (int rounds, std::vector<RigidPose>& poses);

private:
  struct Neighbor {
    int segment;
    int link;
  };

  double
  misfit (int link, const UnpackedPose& first, const UnpackedPose& second) const;
  double
  cost (int segment, const DataTerm::Probe& probe, const UnpackedPose& own) const;
  void
  enterPoses (const std::vector<RigidPose>& poses);
  bool
  isOpen (int segment) const;
  bool
  improve (int segment,
           const std::vector<RigidPose>& poses,
           bool first,
           RigidPose& pose) const;

  const DataTerm& probes_;
  const std::vector<SegmentLink>& links_;
  const EnergyParameters& energy_;
  const double focal_length_;
  const ProposalTuning& tuning_;
  const int threads_;
  std::vector<std::vector<Neighbor>> neighbors_;
  std::vector<std::vector<RigidPose>> own_;
  std::vector<RigidPose> common_;
  std::vector<UnpackedPose> unpacked_common_;
  double flow_worth_{0.0};
  std::vector<char> moving_;          ///< per segment: may it change? empty = all may
  std::vector<char> moved_;           ///< per segment: did it change in the last round?
  std::vector<UnpackedPose> present_; ///< poses of the round
  std::vector<DataTerm::Probe> probed_; ///< at them
  std::vector<char> visible_; ///< per segment: mostly visible at its present pose
};

} // namespace pcl_msf
