// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/hidden_segments.h"

#include <algorithm>
#include <limits>

namespace pcl_msf {

namespace {

constexpr double kHidden = 0.15; // share of visible points: less says nothing
constexpr double kSeen = 0.5;    // enough to lead others

std::vector<double>
visibleShares (const DataTerm& data)
{
  const SegmentPixels& p = data.pixels();
  std::vector<double> shares (p.segments(), 0.0);
  for (int k = 0; k < p.segments(); ++k) {
    int seen = 0;
    for (int i = p.begin[k]; i < p.begin[k + 1]; ++i)
      seen += (data.active()[i] & kernel::kIcp) ? 1 : 0;
    shares[k] = static_cast<double> (seen) / std::max (1, p.size (k));
  }
  return shares;
}

/** A body to follow and how far its segment is. */
struct Leader {
  double lever;
  int body;
};

} // namespace

int
followNeighbors (const DataTerm& data,
                 const std::vector<SegmentLink>& links,
                 MotionState& state)
{
  const std::vector<double> seen = visibleShares (data);
  std::vector<std::vector<Leader>> leaders (seen.size());
  for (const SegmentLink& link : links) {
    if (seen[link.first] < kHidden && seen[link.second] >= kSeen)
      leaders[link.first].push_back ({link.lever, state.body_of[link.second]});
    if (seen[link.second] < kHidden && seen[link.first] >= kSeen)
      leaders[link.second].push_back ({link.lever, state.body_of[link.first]});
  }
  int changes = 0;
  for (std::size_t k = 0; k < leaders.size(); ++k) {
    std::stable_sort (
        leaders[k].begin(), leaders[k].end(), [] (const Leader& a, const Leader& b) {
          return a.lever < b.lever;
        });
    double lowest = std::numeric_limits<double>::infinity();
    int best = state.body_of[k];
    for (const Leader& leader : leaders[k]) {
      const double cost =
          data.probe (static_cast<int> (k), state.poses[leader.body]).cost;
      if (cost < lowest) {
        lowest = cost;
        best = leader.body;
      }
    }
    changes += best != state.body_of[k] ? 1 : 0;
    state.body_of[k] = best;
  }
  return changes;
}

} // namespace pcl_msf
