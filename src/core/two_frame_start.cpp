// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/pose_proposals.h"
#include "core/two_frame_solve.h"

#include <algorithm>

/* The beginning of TwoFrameSolve: poses worth descending from. */
namespace pcl_msf {

namespace {

constexpr int kStartLevel = 1;       // poses are compared at half resolution
constexpr int kStartRounds = 4;      // of proposals
constexpr double kUnexplained = 0.4; // mean cost per residual after the first start

} // namespace

/** Poses worth descending from: the guess, rest, and what optical flow suggests; for
 * segments that these leave unexplained, what the flow of the depth images suggests. */
void
TwoFrameSolve::start (const RigidPose& guess)
{
  const int at = std::min (kStartLevel, levels_ - 1);
  LevelData level = levelData (at, false);
  links_ = linkNearestCentroids (level.probes.centroid, energy_.neighbors);
  state_ = MotionState::fromSegments (std::vector<RigidPose> (segments_.size(), guess),
                                      links_.size());
  common_poses_ = {guess, RigidPose{}};
  std::vector<char> wanted (segments_.size(), 1);
  const auto lift = [&] (const cv::Mat& flow) {
    return hypothesesFromFlow (
        flow, current_, level.probes, wanted, at, noise_, guess, threads_);
  };
  FlowHypotheses flow;
  if (solver_.flow_proposals && reference_.hasIntensity()) {
    flow = lift (estimateOpticalFlow (reference_, current_, threads_));
    change_ = fitBrightnessChange (flow.pairs_reference, flow.pairs_current);
    for (float& intensity : level.probes.intensity)
      intensity = change_.gain * intensity + change_.offset;
  }
  if (!given_start_.empty()) {
    state_ = MotionState::fromSegments (given_start_, links_.size());
    common_poses_.clear();
    return;
  }
  propose (level, flow, kStartRounds);
  wanted = unexplained (level);
  if (solver_.flow_proposals &&
      std::find (wanted.begin(), wanted.end(), 1) != wanted.end())
    propose (
        level, lift (estimateDepthFlow (reference_, current_, threads_)), kStartRounds);
}

/** Lets segments jump to the common poses, their flow's and their neighbours'. */
void
TwoFrameSolve::propose (const LevelData& level, const FlowHypotheses& flow, int rounds)
{
  DataTerm data (
      level.probes, level.texture, makeRules (energy_, level.probes), threads_);
  JointEnergy energy (data, links_, energy_, level.focal_length);
  PoseProposals proposals (energy, links_, threads_);
  common_poses_.insert (common_poses_.end(), flow.bodies.begin(), flow.bodies.end());
  for (const RigidPose& pose : common_poses_)
    proposals.addCommon (pose);
  for (std::size_t k = 0; k < flow.fitted.size(); ++k)
    if (flow.fitted[k])
      proposals.addOwn (static_cast<int> (k), flow.of_segment[k]);
  proposals.run (rounds, state_);
}

/** Which segments do not fit the current frame at their present poses. */
std::vector<char>
TwoFrameSolve::unexplained (const LevelData& level) const
{
  const DataTerm data (
      level.probes, level.texture, makeRules (energy_, level.probes), threads_);
  std::vector<char> result (segments_.size(), 0);
  for (int k = 0; k < segments_.size(); ++k) {
    const DataTerm::Probe probe = data.probe (k, state_.poseOf (k));
    result[k] = probe.cost + probe.hidden * probe.weight * data.unsupportedCost() >
                kUnexplained * probe.weight;
  }
  return result;
}

} // namespace pcl_msf
