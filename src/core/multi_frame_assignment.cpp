// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/claim_map.h"
#include "core/multi_frame_bodies.h"
#include "core/segment_graph.h"

#include <algorithm>
#include <numeric>

namespace pcl_msf {

namespace {

constexpr double kMostlyHidden = 0.5;
constexpr int kLargest = 6;          // bodies that every segment tries
constexpr double kBorderShare = 0.5; // of points that may land on a neighbour's place

class TrajectoryAssignment {
public:
  TrajectoryAssignment (const MultiFrameLevel& level,
                        const MultiFrameScene& scene,
                        const AssignmentRules& rules,
                        MultiFrameState& state);
  int
  round ();
  void
  dropEmptyBodies ();

private:
  std::vector<int>
  largestBodies () const;
  DataTerm::Probe
  probe (int segment, int body) const;
  void
  lookAround ();
  double
  takenShare (int segment, int body) const;
  double
  score (int segment, int body, int background) const;
  int
  choose (int segment, const std::vector<int>& largest) const;

  const MultiFrameLevel& level_;
  const MultiFrameScene& scene_;
  const AssignmentRules& rules_;
  MultiFrameState& state_;
  std::vector<int> asked_; ///< pairs from the reference
  std::vector<std::vector<int>> neighbors_;
  std::vector<char> seen_; ///< per segment: mostly visible on its present trajectory
  std::vector<MotionState> motions_; ///< per asked pair
  std::vector<ClaimMap> claims_;     ///< likewise, of motions_
};

TrajectoryAssignment::TrajectoryAssignment (const MultiFrameLevel& level,
                                            const MultiFrameScene& scene,
                                            const AssignmentRules& rules,
                                            MultiFrameState& state)
: level_ (level)
, scene_ (scene)
, rules_ (rules)
, state_ (state)
, neighbors_ (neighborLists (scene.links, scene.segments))
{
  for (const int p : scene.used)
    if (scene.pairs[p].from == scene.pairs.reference())
      asked_.push_back (p);
}

std::vector<int>
TrajectoryAssignment::largestBodies() const
{
  const SegmentPixels& pixels = level_.pixels (scene_.pairs.reference());
  std::vector<int> points (state_.bodies(), 0);
  for (int k = 0; k < scene_.segments; ++k)
    points[state_.body_of[k]] += pixels.size (k);
  std::vector<int> order (points.size());
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (
      order.begin(), order.end(), [&] (int a, int b) { return points[a] > points[b]; });
  order.resize (std::min<std::size_t> (order.size(), kLargest));
  return order;
}

/** Costs of all asked pairs together. */
DataTerm::Probe
TrajectoryAssignment::probe (int segment, int body) const
{
  DataTerm::Probe sum;
  for (const int p : asked_) {
    const DataTerm::Probe one =
        level_.probes (p).probe (segment, state_.poses[p][body]);
    sum.cost += one.cost;
    sum.weight += one.weight;
    sum.hidden += one.hidden * one.weight;
  }
  sum.hidden = sum.weight > 0.0 ? sum.hidden / sum.weight : 1.0;
  return sum;
}

/** Who is seen, and who claims which place of each frame. */
void
TrajectoryAssignment::lookAround()
{
  seen_.assign (scene_.segments, 0);
#pragma omp parallel for schedule(dynamic, 8) num_threads(scene_.threads)
  for (int k = 0; k < scene_.segments; ++k)
    seen_[k] = probe (k, state_.body_of[k]).hidden < kMostlyHidden;
  claims_.clear();
  motions_.clear();
  for (const int p : asked_)
    motions_.push_back (state_.ofPair (p));
  for (std::size_t i = 0; i < asked_.size(); ++i)
    claims_.emplace_back (level_.data (asked_[i]), motions_[i]);
}

/** Mean over the asked pairs of what ClaimMap calls taken, beyond borders. */
double
TrajectoryAssignment::takenShare (int segment, int body) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < asked_.size(); ++i)
    sum += std::max (0.0,
                     claims_[i].takenShare (level_.probes (asked_[i]), segment, body) -
                         kBorderShare);
  return sum / ((1.0 - kBorderShare) * static_cast<double> (asked_.size()));
}

double
TrajectoryAssignment::score (int segment, int body, int background) const
{
  const auto& near = neighbors_[segment];
  int others = 0;
  bool supported = false;
  for (const int n : near) {
    const bool together = state_.body_of[n] == body;
    others += together ? 0 : 1;
    supported |= together && seen_[n];
  }
  const double share =
      static_cast<double> (others) / std::max<std::size_t> (1, near.size());
  const DataTerm::Probe p = probe (segment, body);
  const double unsupported = level_.probes (asked_.front()).unsupportedCost();
  return p.cost / std::max (p.weight, 1e-12) +
         (supported ? 0.0 : p.hidden * unsupported) + rules_.separation * share +
         (body == background ? 0.0 : rules_.background) +
         takenShare (segment, body) *
             level_.probes (asked_.front()).rules().conflict_cost;
}

int
TrajectoryAssignment::choose (int segment, const std::vector<int>& largest) const
{
  std::vector<int> candidates = largest;
  for (const int n : neighbors_[segment])
    candidates.push_back (state_.body_of[n]);
  std::sort (candidates.begin(), candidates.end());
  candidates.erase (std::unique (candidates.begin(), candidates.end()),
                    candidates.end());
  int best = state_.body_of[segment];
  double lowest = score (segment, best, largest.front());
  for (const int body : candidates) {
    const double s = score (segment, body, largest.front());
    if (s < lowest) {
      lowest = s;
      best = body;
    }
  }
  return best;
}

int
TrajectoryAssignment::round()
{
  const std::vector<int> largest = largestBodies();
  lookAround();
  std::vector<int> next (state_.body_of.size());
  int changes = 0;
#pragma omp parallel for schedule(dynamic, 8) num_threads(scene_.threads) reduction(+ : changes)
  for (int k = 0; k < scene_.segments; ++k) {
    next[k] = choose (k, largest);
    changes += next[k] != state_.body_of[k] ? 1 : 0;
  }
  state_.body_of.swap (next);
  return changes;
}

void
TrajectoryAssignment::dropEmptyBodies()
{
  const auto old = state_.poses;
  for (auto& poses : state_.poses)
    poses.clear();
  std::vector<int> index (old[0].size(), -1);
  int next = 0;
  for (int& body : state_.body_of) {
    if (index[body] < 0) {
      index[body] = next++;
      for (std::size_t p = 0; p < old.size(); ++p)
        state_.poses[p].push_back (old[p][body]);
    }
    body = index[body];
  }
}

} // namespace

void
reassignTrajectories (const MultiFrameLevel& level,
                      const MultiFrameScene& scene,
                      const AssignmentRules& rules,
                      MultiFrameState& state)
{
  TrajectoryAssignment assignment (level, scene, rules, state);
  for (int i = 0; i < rules.rounds; ++i)
    if (assignment.round() == 0)
      break;
  assignment.dropEmptyBodies();
}

} // namespace pcl_msf
