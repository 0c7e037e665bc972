// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/pose_proposals.h"

namespace pcl_msf {

namespace {

constexpr double kClearlyBetter = 0.995; // a change must lower the cost by this factor

} // namespace

PoseProposals::PoseProposals (JointEnergy& energy,
                              const std::vector<SegmentLink>& links,
                              int threads)
: energy_ (energy), links_ (links), threads_ (threads)
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
  double sum = energy_.data().probe (segment, pose);
  for (const Neighbor& n : neighbors_[segment])
    sum += energy_.couplingCost (n.link, pose, state.poseOf (n.segment));
  return sum;
}

bool
PoseProposals::improve (int segment,
                        const MotionState& state,
                        bool first,
                        RigidPose& pose) const
{
  double best = kClearlyBetter * cost (segment, pose, state);
  bool changed = false;
  const auto offer = [&] (const RigidPose& candidate) {
    if (candidate.parameters == pose.parameters)
      return;
    const double c = cost (segment, candidate, state);
    if (c < best) {
      best = c;
      pose = candidate;
      changed = true;
    }
  };
  for (const Neighbor& n : neighbors_[segment])
    offer (state.poseOf (n.segment));
  if (first) {
    for (const RigidPose& candidate : own_[segment])
      offer (candidate);
    for (const RigidPose& candidate : common_)
      offer (candidate);
  }
  return changed;
}

int
PoseProposals::run (int rounds, MotionState& state)
{
  const int segments = static_cast<int> (own_.size());
  int total = 0;
  for (int round = 0; round < rounds; ++round) {
    std::vector<RigidPose> next = state.poses;
    int changes = 0;
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads_) reduction(+ : changes)
    for (int k = 0; k < segments; ++k)
      changes += improve (k, state, round == 0, next[k]) ? 1 : 0;
    state.poses.swap (next);
    total += changes;
    if (changes == 0)
      break;
  }
  return total;
}

} // namespace pcl_msf
