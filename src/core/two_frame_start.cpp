// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/pose_proposals.h"
#include "core/segment_graph.h"
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
  const FrameLevel& reference = frames_[0].levels()[at];
  SegmentPixels points =
      probePoints (reference, labels_[at], scene_.segments, pointOptions (scene_, at));
  scene_.links = linkNearestCentroids (points.centroid, energy_.neighbors);
  std::vector<char> wanted (segments_.size(), 1);
  const auto lift = [&] (const cv::Mat& flow) {
    return hypothesesFromFlow (
        flow, frames_[1], points, wanted, at, scene_.noise, guess, scene_.threads);
  };
  FlowHypotheses flow;
  if (solver_.flow_proposals && frames_[0].hasIntensity()) {
    flow = lift (estimateOpticalFlow (frames_[0], frames_[1], scene_.threads));
    scene_.change = fitBrightnessChange (flow.pairs_reference, flow.pairs_current);
    for (float& intensity : points.intensity)
      intensity = scene_.change.gain * intensity + scene_.change.offset;
  }
  const bool given = !given_start_.empty();
  state_ = WindowState (MotionState::fromSegments (
      given ? given_start_ : std::vector<RigidPose> (segments_.size(), guess),
      scene_.links.size()));
  if (given)
    return;
  common_poses_ = {guess, RigidPose{}};
  const Texture texture (frames_[1].levels()[at]);
  const DataTerm probes (points, texture, makeRules (energy_, points), scene_.threads);
  propose (probes, reference.camera.fx, flow, kStartRounds);
  wanted = unexplained (probes);
  if (solver_.flow_proposals &&
      std::find (wanted.begin(), wanted.end(), 1) != wanted.end())
    propose (probes,
             reference.camera.fx,
             lift (estimateDepthFlow (frames_[0], frames_[1], scene_.threads)),
             kStartRounds);
}

/** Lets segments jump to the common poses, their flow's and their neighbours'. */
void
TwoFrameSolve::propose (const DataTerm& probes,
                        double focal_length,
                        const FlowHypotheses& flow,
                        int rounds)
{
  PoseProposals proposals (probes, scene_.links, energy_, focal_length, scene_.threads);
  common_poses_.insert (common_poses_.end(), flow.bodies.begin(), flow.bodies.end());
  for (const RigidPose& pose : common_poses_)
    proposals.addCommon (pose);
  for (std::size_t k = 0; k < flow.fitted.size(); ++k)
    if (flow.fitted[k])
      proposals.addOwn (static_cast<int> (k), flow.of_segment[k]);
  proposals.run (rounds, state_.poses[0]);
}

/** Which segments do not fit the current frame at their present poses. */
std::vector<char>
TwoFrameSolve::unexplained (const DataTerm& probes) const
{
  std::vector<char> result (segments_.size(), 0);
  for (int k = 0; k < segments_.size(); ++k) {
    const DataTerm::Probe probe = probes.probe (k, state_.poses[0][k]);
    result[k] = probe.cost + probe.hidden * probe.weight * probes.unsupportedCost() >
                kUnexplained * probe.weight;
  }
  return result;
}

} // namespace pcl_msf
