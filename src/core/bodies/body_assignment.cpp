// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/bodies/body_assignment.h"

#include "core/base/parallel_for.h"
#include "core/bodies/landing_map.h"
#include "core/segments/segment_graph.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>

namespace pcl_msf {

namespace {

double
meanCost (const DataTerm::Probe& probe)
{
  return probe.cost / std::max (probe.weight, 1e-12);
}

class Assignment {
public:
  Assignment (const std::vector<PairTerms>& terms,
              const std::vector<SegmentLink>& links,
              const AssignmentTuning& tuning,
              const AssignmentRules& rules,
              WindowState& state);

  int
  round (int threads);

private:
  /** The bodies that every segment tries: those of most points that are seen. */
  std::vector<int>
  largestBodies () const;
  DataTerm::Probe
  probe (int segment, int body);
  void
  measureFits (int threads);
  void
  mapLandings (int threads);
  double
  occupiedShare (int segment, int body, double cost) const;
  double
  score (int segment, int body, double limit);
  int
  choose (int segment, const std::vector<int>& candidates);

  /** Of a segment with a body's poses, which no round changes. */
  struct KnownProbe {
    int body;
    DataTerm::Probe probe;
  };

  const std::vector<PairTerms> pairs_;
  const AssignmentTuning& tuning_;
  const bool hides_;         ///< see AssignmentRules
  const double separation_;  ///< cost of leaving all neighbours
  const double least_prior_; ///< cost of leaving the largest body, at the least
  WindowState& state_;
  std::vector<std::vector<UnpackedPose>> unpacked_; ///< per pair, per body
  const int segments_;
  std::vector<std::vector<int>> neighbors_;
  std::vector<std::vector<double>> strengths_; ///< of the links to them
  int largest_{0};                             ///< body
  std::vector<std::vector<KnownProbe>> known_; ///< per segment
  std::vector<double> hidden_;                 ///< per segment: share, with its body
  std::vector<double> costs_;                  ///< likewise: mean cost per residual
  std::vector<MotionState> motions_;           ///< per pair
  std::vector<std::unique_ptr<LandingMap>> landings_; ///< likewise, of motions_
};

Assignment::Assignment (const std::vector<PairTerms>& terms,
                        const std::vector<SegmentLink>& links,
                        const AssignmentTuning& tuning,
                        const AssignmentRules& rules,
                        WindowState& state)
: pairs_ (fromReference (terms))
, tuning_ (tuning)
, hides_ (rules.hides)
, separation_ (rules.window ? tuning.window_separation : tuning.separation)
, least_prior_ (rules.background ? tuning.most_prior : 0.0)
, state_ (state)
, segments_ (static_cast<int> (state.body_of.size()))
, neighbors_ (neighborLists (links, segments_))
, strengths_ (segments_)
, known_ (segments_)
{
  for (const std::vector<RigidPose>& poses : state.poses)
    unpacked_.emplace_back (poses.begin(), poses.end());
  for (const SegmentLink& l : links) {
    strengths_[l.first].push_back (l.strength);
    strengths_[l.second].push_back (l.strength);
  }
}

std::vector<int>
Assignment::largestBodies() const
{
  std::vector<double> points (state_.bodies(), 0.0);
  std::vector<int> segments (state_.bodies(), 0);
  for (int k = 0; k < segments_; ++k) {
    points[state_.body_of[k]] +=
        (1.0 - hidden_[k]) * pairs_.front().sample->pixels().size (k);
    ++segments[state_.body_of[k]];
  }
  std::vector<int> order (points.size());
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (
      order.begin(), order.end(), [&] (int a, int b) { return points[a] > points[b]; });
  order.resize (std::min<std::size_t> (order.size(), tuning_.largest));
  const auto small = [&] (int body) {
    return segments[body] < tuning_.least_share * segments_;
  };
  order.erase (std::remove_if (order.begin() + 1, order.end(), small), order.end());
  return order;
}

/** Costs of all pairs together; `hidden` is their mean by weight. */
DataTerm::Probe
Assignment::probe (int segment, int body)
{
  for (const KnownProbe& known : known_[segment])
    if (known.body == body)
      return known.probe;
  DataTerm::Probe sum;
  for (const PairTerms& pair : pairs_) {
    const DataTerm::Probe one =
        pair.sample->probe (segment, unpacked_[pair.pair][body]);
    sum.cost += one.cost + tuning_.flow_worth * one.flow;
    sum.weight += one.weight;
    sum.hidden += one.hidden * one.weight;
  }
  sum.hidden = sum.weight > 0.0 ? sum.hidden / sum.weight : 1.0;
  known_[segment].push_back ({body, sum});
  return sum;
}

/** Mean over the pairs of what is occupied, beyond borders. */
double
Assignment::occupiedShare (int segment, int body, double cost) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    sum +=
        std::max (0.0,
                  landings_[i]->occupiedShare (*pairs_[i].sample, segment, body, cost) -
                      tuning_.border_share);
  return sum / ((1.0 - tuning_.border_share) * static_cast<double> (pairs_.size()));
}

/** That a segment would be unseen with the largest body does not contradict it: as much
 * more evidence is wanted for leaving. */
double
Assignment::score (int segment, int body, double limit)
{
  const auto& near = neighbors_[segment];
  double others = 0.0;
  double all = 0.0;
  bool supported = false;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const int n = near[i];
    const bool together = state_.body_of[n] == body;
    others += together ? 0.0 : strengths_[segment][i];
    all += strengths_[segment][i];
    supported |= together &&
                 ((hides_ && body == largest_) || hidden_[n] < tuning_.mostly_hidden);
  }
  const double share = all > 0.0 ? others / all : 0.0;
  const DataTerm& sample = *pairs_.front().sample;
  const DataTerm::Probe p = probe (segment, body);
  const double hidden = supported ? 0.0 : p.hidden * sample.isolatedHiddenCost();
  const double independent = p.weight * pairs_.front().residual_scale;
  const double unseen =
      hides_ ? probe (segment, largest_).hidden * sample.rules().occluded_cost : 0.0;
  const double prior =
      std::max (least_prior_,
                std::min (tuning_.most_prior + unseen,
                          tuning_.prior / std::max (1.0, independent)));
  const double sum =
      meanCost (p) + hidden + separation_ * share + (body == largest_ ? 0.0 : prior);
  return sum >= limit ? sum
                      : sum + occupiedShare (segment, body, meanCost (p)) *
                                  sample.rules().conflict_cost;
}

int
Assignment::choose (int segment, const std::vector<int>& largest)
{
  std::vector<int> candidates = largest;
  for (const int n : neighbors_[segment])
    candidates.push_back (state_.body_of[n]);
  std::sort (candidates.begin(), candidates.end());
  candidates.erase (std::unique (candidates.begin(), candidates.end()),
                    candidates.end());
  int best = state_.body_of[segment];
  double lowest = score (segment, best, std::numeric_limits<double>::infinity());
  for (const int body : candidates) {
    const double s = score (segment, body, lowest);
    if (s < lowest) {
      lowest = s;
      best = body;
    }
  }
  return best;
}

void
Assignment::measureFits (int threads)
{
  hidden_.assign (segments_, 0.0);
  costs_.assign (segments_, 0.0);
  parallelFor (threads, segments_, 8, [&] (int k) {
    const DataTerm::Probe p = probe (k, state_.body_of[k]);
    hidden_[k] = p.hidden;
    costs_[k] = meanCost (p);
  });
}

void
Assignment::mapLandings (int threads)
{
  const int pairs = static_cast<int> (pairs_.size());
  motions_.clear();
  for (const PairTerms& pair : pairs_)
    motions_.push_back (state_.ofPair (pair.pair));
  landings_.resize (pairs);
  const bool many = pairs > 1; // else threads share a pair's segments
  parallelFor (many ? threads : 1, pairs, 1, [&] (int i) {
    if (!landings_[i])
      landings_[i] = std::make_unique<LandingMap> (*pairs_[i].all, tuning_.landings);
    landings_[i]->enter (motions_[i], costs_, many ? 1 : threads);
  });
}

int
Assignment::round (int threads)
{
  measureFits (threads);
  const std::vector<int> largest = largestBodies();
  largest_ = largest.front();
  mapLandings (threads);
  std::vector<int> next (segments_);
  const int changes = parallelSum (threads, segments_, 8, [&] (int k) {
    next[k] = choose (k, largest);
    return next[k] != state_.body_of[k] ? 1 : 0;
  });
  state_.body_of.swap (next);
  return changes;
}

} // namespace

int
reassignBodies (const std::vector<PairTerms>& terms,
                const std::vector<SegmentLink>& links,
                const AssignmentTuning& tuning,
                const AssignmentRules& rules,
                int threads,
                WindowState& state)
{
  Assignment assignment (terms, links, tuning, rules, state);
  int total = 0;
  for (int i = 0; i < tuning.rounds; ++i) {
    const int changes = assignment.round (threads);
    total += changes;
    if (changes == 0)
      break;
  }
  state.renumberBodies();
  return total;
}

} // namespace pcl_msf
