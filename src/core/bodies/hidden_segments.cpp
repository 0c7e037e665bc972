// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/bodies/hidden_segments.h"

#include <algorithm>
#include <limits>

namespace pcl_msf {

namespace {

/** Per segment, the share of its points that are seen, in the mean over the pairs. */
std::vector<double>
visibleShares (const std::vector<PairTerms>& terms)
{
  const SegmentPixels& p = terms.front().all->pixels();
  std::vector<double> shares (p.segments(), 0.0);
  for (int k = 0; k < p.segments(); ++k) {
    int seen = 0;
    for (const PairTerms& pair : terms)
      for (int i = p.begin[k]; i < p.begin[k + 1]; ++i)
        seen += (pair.all->active()[i] & kernel::kIcp) ? 1 : 0;
    const int points = p.size (k) * static_cast<int> (terms.size());
    shares[k] = static_cast<double> (seen) / std::max (1, points);
  }
  return shares;
}

/** A body to join and how far its segment is. */
struct Candidate {
  double lever;
  int body;
};

} // namespace

int
assignHiddenSegments (const std::vector<PairTerms>& all_terms,
                      const std::vector<SegmentLink>& links,
                      const HiddenTuning& tuning,
                      WindowState& state)
{
  const std::vector<PairTerms> terms = fromReference (all_terms);
  const std::vector<double> seen = visibleShares (terms);
  std::vector<std::vector<Candidate>> candidates (seen.size());
  for (const SegmentLink& link : links) {
    if (seen[link.first] < tuning.hidden && seen[link.second] >= tuning.seen)
      candidates[link.first].push_back ({link.lever, state.body_of[link.second]});
    if (seen[link.second] < tuning.hidden && seen[link.first] >= tuning.seen)
      candidates[link.second].push_back ({link.lever, state.body_of[link.first]});
  }
  int changes = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    std::stable_sort (
        candidates[k].begin(),
        candidates[k].end(),
        [] (const Candidate& a, const Candidate& b) { return a.lever < b.lever; });
    double lowest = std::numeric_limits<double>::infinity();
    int best = state.body_of[k];
    for (const Candidate& candidate : candidates[k]) {
      double cost = 0.0;
      for (const PairTerms& pair : terms)
        cost +=
            pair.all
                ->probe (static_cast<int> (k), state.poses[pair.pair][candidate.body])
                .cost;
      if (cost < lowest) {
        lowest = cost;
        best = candidate.body;
      }
    }
    changes += best != state.body_of[k] ? 1 : 0;
    state.body_of[k] = best;
  }
  return changes;
}

} // namespace pcl_msf
