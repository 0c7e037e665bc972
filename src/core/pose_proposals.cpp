// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/pose_proposals.h"

#include "core/parallel_for.h"

#include <algorithm>

namespace pcl_msf {

namespace {

constexpr double kOwnWay = 0.05;      // mean cost that a motion of one's own must save
constexpr double kMostlyHidden = 0.5; // share of residuals
constexpr double kClearlyBetter = 0.995; // a change must lower the cost by this factor

} // namespace

PoseProposals::PoseProposals (JointEnergy& energy,
                              const std::vector<SegmentLink>& links,
                              int threads)
: energy_ (energy), threads_ (threads)
{
  const int segments = energy.data().pixels().segments();
  neighbors_.resize (segments);
  own_.resize (segments);
  for (std::size_t i = 0; i < links.size(); ++i) {
    neighbors_[links[i].first].push_back ({links[i].second, static_cast<int> (i)});
    neighbors_[links[i].second].push_back ({links[i].first, static_cast<int> (i)});
  }
}

double
PoseProposals::cost (int segment, const RigidPose& pose, const MotionState& state) const
{
  const DataTerm::Probe probe = energy_.data().probe (segment, pose);
  const UnpackedPose own (pose);
  double sum = probe.cost;
  double support = 0.0; // the strongest connection to a neighbour that is seen
  for (const Neighbor& n : neighbors_[segment]) {
    const UnpackedPose& other = present_[state.body_of[n.segment]];
    sum += energy_.couplingCost (n.link, own, other);
    if (seen_[n.segment])
      support = std::max (support, energy_.linkStrength (n.link, own, other));
  }
  return sum + probe.weight * probe.hidden * (1.0 - support) *
                   energy_.data().unsupportedCost();
}

void
PoseProposals::lookWhoIsSeen (const MotionState& state)
{
  const int segments = static_cast<int> (own_.size());
  present_ = std::vector<UnpackedPose> (state.poses.begin(), state.poses.end());
  seen_.assign (segments, 0);
  parallelFor (threads_, segments, 8, [&] (int k) {
    seen_[k] = energy_.data().probe (k, state.poseOf (k)).hidden < kMostlyHidden;
  });
}

bool
PoseProposals::improve (int segment,
                        const MotionState& state,
                        bool first,
                        RigidPose& pose) const
{
  double best = kClearlyBetter * cost (segment, pose, state);
  bool changed = false;
  const double alone = kOwnWay * energy_.data().totalWeight (segment);
  const auto offer = [&] (const RigidPose& candidate, double extra) {
    if (candidate.parameters == pose.parameters)
      return;
    const double c = cost (segment, candidate, state) + extra;
    if (c < best) {
      best = c;
      pose = candidate;
      changed = true;
    }
  };
  for (const Neighbor& n : neighbors_[segment])
    offer (state.poseOf (n.segment), 0.0);
  if (first) {
    for (const RigidPose& candidate : own_[segment])
      offer (candidate, alone);
    for (const RigidPose& candidate : common_)
      offer (candidate, 0.0);
  }
  return changed;
}

int
PoseProposals::run (int rounds, MotionState& state)
{
  const int segments = static_cast<int> (own_.size());
  int total = 0;
  for (int round = 0; round < rounds; ++round) {
    lookWhoIsSeen (state);
    std::vector<RigidPose> next = state.poses;
    const int changes = parallelSum (threads_, segments, 8, [&] (int k) {
      return improve (k, state, round == 0, next[k]) ? 1 : 0;
    });
    state.poses.swap (next);
    total += changes;
    if (changes == 0)
      break;
  }
  return total;
}

} // namespace pcl_msf
