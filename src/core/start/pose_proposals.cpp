// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/start/pose_proposals.h"

#include "core/base/parallel_for.h"
#include "core/energy/pose_coupling.h"

#include <algorithm>

namespace pcl_msf {

PoseProposals::PoseProposals (const DataTerm& probes,
                              const std::vector<SegmentLink>& links,
                              const EnergyParameters& energy,
                              double focal_length,
                              const ProposalTuning& tuning,
                              int threads)
: probes_ (probes)
, links_ (links)
, energy_ (energy)
, focal_length_ (focal_length)
, tuning_ (tuning)
, threads_ (threads)
{
  const int segments = probes.pixels().segments();
  neighbors_.resize (segments);
  own_.resize (segments);
  for (std::size_t i = 0; i < links.size(); ++i) {
    neighbors_[links[i].first].push_back ({links[i].second, static_cast<int> (i)});
    neighbors_[links[i].second].push_back ({links[i].first, static_cast<int> (i)});
  }
}

/** gamma |d|^2 of a link (Eq. 10 at full weight). */
double
PoseProposals::misfit (int link,
                       const UnpackedPose& first,
                       const UnpackedPose& second) const
{
  const SegmentLink& l = links_[link];
  const double unit = focal_length_ / std::max (l.midpoint.z(), 1e-3);
  return energy_.regularizer_weight *
         poseDifference (first, second, l, unit, energy_.pose_difference).squaredNorm();
}

/** Data cost, and Eq. 10 and 11 of the segment's links at their best weights. */
double
PoseProposals::cost (int segment, const RigidPose& pose) const
{
  const DataTerm::Probe probe = probes_.probe (segment, pose);
  const UnpackedPose own (pose);
  const double eta = energy_.prior_weight;
  double sum = probe.cost + flow_worth_ * probe.flow;
  double support = 0.0; // the strongest connection to a neighbour that is seen
  for (const Neighbor& n : neighbors_[segment]) {
    const double m = misfit (n.link, own, present_[n.segment]);
    sum += 0.5 * tuning_.rough * m * eta / ((m + eta) * links_.size());
    if (visible_[n.segment])
      support = std::max (support, eta / (m + eta));
  }
  return sum +
         probe.weight * probe.hidden * (1.0 - support) * probes_.isolatedHiddenCost();
}

void
PoseProposals::findVisibleSegments (const std::vector<RigidPose>& poses)
{
  const int segments = static_cast<int> (own_.size());
  present_ = std::vector<UnpackedPose> (poses.begin(), poses.end());
  visible_.assign (segments, 0);
  parallelFor (threads_, segments, 8, [&] (int k) {
    visible_[k] = probes_.probe (k, poses[k]).hidden < tuning_.mostly_hidden;
  });
}

bool
PoseProposals::improve (int segment,
                        const std::vector<RigidPose>& poses,
                        bool first,
                        RigidPose& pose) const
{
  double best = tuning_.clearly_better * cost (segment, pose);
  bool changed = false;
  const double alone = tuning_.own_penalty * probes_.totalWeight (segment);
  std::vector<const RigidPose*> tried; // neighbours often share a motion
  const auto offer = [&] (const RigidPose& candidate, double extra) {
    const auto same = [&] (const RigidPose* other) {
      return other->parameters == candidate.parameters;
    };
    if (same (&pose) || std::any_of (tried.begin(), tried.end(), same))
      return;
    if (extra == 0.0)
      tried.push_back (&candidate);
    const double c = cost (segment, candidate) + extra;
    if (c < best) {
      best = c;
      pose = candidate;
      changed = true;
    }
  };
  for (const Neighbor& n : neighbors_[segment])
    offer (poses[n.segment], 0.0);
  if (first) {
    for (const RigidPose& candidate : own_[segment])
      offer (candidate, alone);
    for (const RigidPose& candidate : common_)
      offer (candidate, 0.0);
  }
  return changed;
}

int
PoseProposals::run (int rounds, std::vector<RigidPose>& poses)
{
  const int segments = static_cast<int> (own_.size());
  int total = 0;
  for (int round = 0; round < rounds; ++round) {
    findVisibleSegments (poses);
    std::vector<RigidPose> next = poses;
    const int changes = parallelSum (threads_, segments, 8, [&] (int k) {
      const bool stays = !moving_.empty() && moving_[k] == 0;
      return !stays && improve (k, poses, round == 0, next[k]) ? 1 : 0;
    });
    poses.swap (next);
    total += changes;
    if (changes == 0)
      break;
  }
  return total;
}

} // namespace pcl_msf
