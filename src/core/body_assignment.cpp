// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/body_assignment.h"

#include "core/claim_map.h"
#include "core/segment_graph.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl_msf {

namespace {

constexpr double kMostlyHidden = 0.5;
constexpr int kLargest = 6;          // bodies that every segment tries
constexpr double kBorderShare = 0.5; // of points that may land on a neighbour's place

class Assignment {
public:
  Assignment (const DataTerm& dense,
              const DataTerm& data,
              const std::vector<SegmentLink>& links,
              double separation,
              MotionState& state)
  : dense_ (dense)
  , data_ (data)
  , separation_ (separation)
  , state_ (state)
  , neighbors_ (neighborLists (links, data.pixels().segments()))
  {}

  int
  round (int threads);
  void
  dropEmptyBodies ();

private:
  std::vector<int>
  largestBodies () const;
  void
  lookWhoIsSeen (int threads);
  double
  score (int segment, int body, const ClaimMap& claims, double limit) const;
  int
  choose (int segment, const std::vector<int>& largest, const ClaimMap& claims) const;

  const DataTerm& dense_;
  const DataTerm& data_; ///< a sample of it
  double separation_;
  MotionState& state_;
  std::vector<std::vector<int>> neighbors_;
  std::vector<char> seen_; ///< per segment: mostly visible with its present body
};

std::vector<int>
Assignment::largestBodies() const
{
  std::vector<int> points (state_.poses.size(), 0);
  for (std::size_t k = 0; k < state_.body_of.size(); ++k)
    points[state_.body_of[k]] += data_.pixels().size (static_cast<int> (k));
  std::vector<int> order (points.size());
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (
      order.begin(), order.end(), [&] (int a, int b) { return points[a] > points[b]; });
  order.resize (std::min<std::size_t> (order.size(), kLargest));
  return order;
}

double
Assignment::score (int segment, int body, const ClaimMap& claims, double limit) const
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
  const DataTerm::Probe probe = data_.probe (segment, state_.poses[body]);
  const double hidden = supported ? 0.0 : probe.hidden * data_.unsupportedCost();
  const double sum =
      probe.cost / std::max (probe.weight, 1e-12) + hidden + separation_ * share;
  if (sum >= limit)
    return sum;
  const double taken =
      std::max (0.0, claims.takenShare (data_, segment, body) - kBorderShare) /
      (1.0 - kBorderShare);
  return sum + taken * data_.rules().conflict_cost;
}

int
Assignment::choose (int segment,
                    const std::vector<int>& largest,
                    const ClaimMap& claims) const
{
  std::vector<int> candidates = largest;
  for (const int n : neighbors_[segment])
    candidates.push_back (state_.body_of[n]);
  std::sort (candidates.begin(), candidates.end());
  candidates.erase (std::unique (candidates.begin(), candidates.end()),
                    candidates.end());
  int best = state_.body_of[segment];
  double lowest =
      score (segment, best, claims, std::numeric_limits<double>::infinity());
  for (const int body : candidates) {
    const double s = score (segment, body, claims, lowest);
    if (s < lowest) {
      lowest = s;
      best = body;
    }
  }
  return best;
}

void
Assignment::lookWhoIsSeen (int threads)
{
  const int segments = static_cast<int> (state_.body_of.size());
  seen_.assign (segments, 0);
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads)
  for (int k = 0; k < segments; ++k)
    seen_[k] = data_.probe (k, state_.poseOf (k)).hidden < kMostlyHidden;
}

int
Assignment::round (int threads)
{
  const std::vector<int> largest = largestBodies();
  lookWhoIsSeen (threads);
  const ClaimMap claims (dense_, state_);
  std::vector<int> next (state_.body_of.size());
  const int segments = static_cast<int> (next.size());
  int changes = 0;
#pragma omp parallel for schedule(dynamic, 8) num_threads(threads) reduction(+ : changes)
  for (int k = 0; k < segments; ++k) {
    next[k] = choose (k, largest, claims);
    changes += next[k] != state_.body_of[k] ? 1 : 0;
  }
  state_.body_of.swap (next);
  return changes;
}

void
Assignment::dropEmptyBodies()
{
  std::vector<int> index (state_.poses.size(), -1);
  std::vector<RigidPose> poses;
  for (int& body : state_.body_of) {
    if (index[body] < 0) {
      index[body] = static_cast<int> (poses.size());
      poses.push_back (state_.poses[body]);
    }
    body = index[body];
  }
  state_.poses.swap (poses);
}

} // namespace

int
reassignBodies (const DataTerm& dense,
                const DataTerm& data,
                const std::vector<SegmentLink>& links,
                double separation,
                int rounds,
                int threads,
                MotionState& state)
{
  Assignment assignment (dense, data, links, separation, state);
  int total = 0;
  for (int i = 0; i < rounds; ++i) {
    const int changes = assignment.round (threads);
    total += changes;
    if (changes == 0)
      break;
  }
  assignment.dropEmptyBodies();
  return total;
}

} // namespace pcl_msf
