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

/** Data cost, and Eq. 10 and 11 of the segment's links at their best weights.
 * \param probe of the segment at the pose \param own the pose */
double
PoseProposals::cost (int segment,
                     const DataTerm::Probe& probe,
                     const UnpackedPose& own) const
{
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

/** Looks at segments that moved in the last round. */
void
PoseProposals::enterPoses (const std::vector<RigidPose>& poses)
{
  parallelFor (threads_, static_cast<int> (poses.size()), 8, [&] (int k) {
    if (moved_[k] == 0)
      return;
    present_[k] = UnpackedPose (poses[k]);
    probed_[k] = probes_.probe (k, present_[k]);
    visible_[k] = probed_[k].hidden < tuning_.mostly_hidden;
  });
}

/** May a round change a segment? Not where it may not change, and not where nothing is
 * new since it stayed. */
bool
PoseProposals::isOpen (int segment) const
{
  if (!moving_.empty() && moving_[segment] == 0)
    return false;
  return moved_[segment] != 0 ||
         std::any_of (neighbors_[segment].begin(),
                      neighbors_[segment].end(),
                      [this] (const Neighbor& n) { return moved_[n.segment] != 0; });
}

bool
PoseProposals::improve (int segment,
                        const std::vector<RigidPose>& poses,
                        bool first,
                        RigidPose& pose) const
{
  double best =
      tuning_.clearly_better * cost (segment, probed_[segment], present_[segment]);
  bool changed = false;
  const double alone = tuning_.own_penalty * probes_.totalWeight (segment);
  std::vector<const RigidPose*> tried; // neighbours often share a motion
  const auto offer =
      [&] (const RigidPose& candidate, const UnpackedPose& unpacked, double extra) {
        const auto same = [&] (const RigidPose* other) {
          return other->parameters == candidate.parameters;
        };
        if (same (&pose) || std::any_of (tried.begin(), tried.end(), same))
          return;
        if (extra == 0.0)
          tried.push_back (&candidate);
        const double c =
            cost (segment, probes_.probe (segment, unpacked), unpacked) + extra;
        if (c < best) {
          best = c;
          pose = candidate;
          changed = true;
        }
      };
  for (const Neighbor& n : neighbors_[segment])
    offer (poses[n.segment], present_[n.segment], 0.0);
  if (first) {
    for (const RigidPose& candidate : own_[segment])
      offer (candidate, candidate, alone);
    for (std::size_t i = 0; i < common_.size(); ++i)
      offer (common_[i], unpacked_common_[i], 0.0);
  }
  return changed;
}

int
PoseProposals::run (int rounds, std::vector<RigidPose>& poses)
{
  const int segments = static_cast<int> (own_.size());
  int total = 0;
  moved_.assign (segments, 1);
  present_ = std::vector<UnpackedPose> (poses.begin(), poses.end());
  unpacked_common_ = std::vector<UnpackedPose> (common_.begin(), common_.end());
  probed_.resize (segments);
  visible_.resize (segments);
  for (int round = 0; round < rounds; ++round) {
    enterPoses (poses);
    std::vector<RigidPose> next = poses;
    std::vector<char> moves (segments, 0);
    const int changes = parallelSum (threads_, segments, 8, [&] (int k) {
      moves[k] = isOpen (k) && improve (k, poses, round == 0, next[k]) ? 1 : 0;
      return moves[k];
    });
    poses.swap (next);
    moved_.swap (moves);
    total += changes;
    if (changes == 0)
      break;
  }
  return total;
}

} // namespace pcl_msf
