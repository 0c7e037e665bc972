// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/bodies/body_merging.h"

#include <Eigen/Cholesky>

#include "core/base/merge_queue.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr double kRounding = 1e-7; // of sums of single-precision products, relative

/** E (x) = 1/2 x' A x - h' x + const over a pair's six pose parameters. */
struct PoseQuadratic {
  Matrix6 a{Matrix6::Zero()};
  Vector6 h{Vector6::Zero()};
  Vector6 best{Vector6::Zero()}; ///< its minimum, near the prior where A says nothing

  /** \return the minimum's energy */
  double
  solve (const Vector6& prior)
  {
    Matrix6 m = a;
    const double ridge = kRounding * a.trace() + 1e-15;
    m.diagonal().array() += ridge;
    best = Eigen::LDLT<Matrix6> (m).solve (h + ridge * prior);
    return 0.5 * best.dot (a * best) - h.dot (best);
  }
};

/** A body's quadratics in all pairs. */
struct BodyQuadratics {
  std::vector<PoseQuadratic> pairs;
  double points{0.0}; ///< independent ones
  double minimum{0.0};
  bool used{false}; ///< has segments
};

PoseQuadratic
sum (const PoseQuadratic& a, const PoseQuadratic& b)
{
  PoseQuadratic result;
  result.a = a.a + b.a;
  result.h = a.h + b.h;
  return result;
}

BodyQuadratics
sum (const BodyQuadratics& a, const BodyQuadratics& b)
{
  BodyQuadratics result;
  result.used = true;
  result.points = a.points + b.points;
  const BodyQuadratics& larger = a.points >= b.points ? a : b;
  for (std::size_t p = 0; p < a.pairs.size(); ++p) {
    result.pairs.push_back (sum (a.pairs[p], b.pairs[p]));
    result.minimum += result.pairs.back().solve (larger.pairs[p].best);
  }
  return result;
}

/** How much one common motion costs more than two. */
double
increase (const BodyQuadratics& a, const BodyQuadratics& b)
{
  const BodyQuadratics& larger = a.points >= b.points ? a : b;
  double minimum = 0.0;
  for (std::size_t p = 0; p < a.pairs.size(); ++p)
    minimum += sum (a.pairs[p], b.pairs[p]).solve (larger.pairs[p].best);
  return minimum - a.minimum - b.minimum;
}

/** Of a segment, each counting for all of its residuals. */
double
independentPoints (const PairTerms& terms, int segment)
{
  const SegmentPixels& pixels = terms.all->pixels();
  const int residuals = (pixels.brightness_count > 0) + (pixels.icp_count > 0);
  return terms.residual_scale * terms.all->totalWeight (segment) /
         std::max (1, residuals);
}

class Merger {
public:
  Merger (const std::vector<PairTerms>& terms,
          int frames,
          const std::vector<SegmentLink>& links,
          const MergeTuning& tuning,
          WindowState& state);

  void
  run ();

private:
  void
  addPair (const PairTerms& terms);
  void
  connect (const std::vector<SegmentLink>& links);
  void
  consider (int a, int b);
  void
  merge (int a, int b);
  void
  mergeQueued ();
  bool
  considerLargest ();
  void
  writeBack ();

  const std::vector<PairTerms>& terms_;
  const double strictness_; ///< of the allowances
  const MergeTuning tuning_;
  WindowState& state_;
  std::vector<BodyQuadratics> bodies_;
  MergeQueue queue_;
};

Merger::Merger (const std::vector<PairTerms>& terms,
                int frames,
                const std::vector<SegmentLink>& links,
                const MergeTuning& tuning,
                WindowState& state)
: terms_ (terms)
, strictness_ (std::sqrt (frames - 1.0))
, tuning_ (tuning)
, state_ (state)
, bodies_ (state.bodies())
, queue_ (state.bodies())
{
  for (const PairTerms& pair : terms)
    addPair (pair);
  const PairTerms own = fromReference (terms).front();
  for (std::size_t k = 0; k < state.body_of.size(); ++k) {
    bodies_[state.body_of[k]].points += independentPoints (own, static_cast<int> (k));
    bodies_[state.body_of[k]].used = true;
  }
  connect (links);
}

void
Merger::addPair (const PairTerms& terms)
{
  const auto& poses = state_.poses[terms.pair];
  for (BodyQuadratics& body : bodies_)
    body.pairs.emplace_back();
  for (std::size_t k = 0; k < state_.body_of.size(); ++k) {
    const int b = state_.body_of[k];
    const Eigen::Map<const Vector6> pose (poses[b].parameters.data());
    const SegmentQuadratic& q = terms.all->of (static_cast<int> (k));
    PoseQuadratic& body = bodies_[b].pairs.back();
    body.a += terms.residual_scale * q.information;
    body.h += terms.residual_scale * (q.information * pose - q.gradient);
  }
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    bodies_[b].minimum += bodies_[b].pairs.back().solve (
        Eigen::Map<const Vector6> (poses[b].parameters.data()));
}

void
Merger::connect (const std::vector<SegmentLink>& links)
{
  for (const SegmentLink& link : links) {
    const int a = state_.body_of[link.first];
    const int b = state_.body_of[link.second];
    if (a != b)
      queue_.link (a, b);
  }
  for (int a = 0; a < static_cast<int> (bodies_.size()); ++a)
    for (const int b : queue_.neighbors (a))
      if (a < b)
        consider (a, b);
}

void
Merger::consider (int a, int b)
{
  const BodyQuadratics& first = bodies_[a];
  const BodyQuadratics& second = bodies_[b];
  const double costs = increase (first, second);
  const double allowed =
      strictness_ *
      (tuning_.allowance + tuning_.per_point * std::min (first.points, second.points));
  if (costs < allowed)
    queue_.offer (costs, a, b);
}

void
Merger::merge (int a, int b)
{
  bodies_[a] = sum (bodies_[a], bodies_[b]);
  queue_.merge (a, b);
  for (const int n : queue_.neighbors (a))
    consider (std::min (a, n), std::max (a, n));
}

/** Offers every body to the largest ones, which it may not touch: furniture in front of
 * a wall has only itself as neighbours. \return whether there is anything to merge */
bool
Merger::considerLargest()
{
  std::vector<int> order;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].used && queue_.isLeft (static_cast<int> (b)))
      order.push_back (static_cast<int> (b));
  std::stable_sort (order.begin(), order.end(), [&] (int a, int b) {
    return bodies_[a].points > bodies_[b].points;
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = 0; j < std::min<std::size_t> (i, tuning_.largest); ++j)
      consider (std::min (order[i], order[j]), std::max (order[i], order[j]));
  return !queue_.empty();
}

void
Merger::mergeQueued()
{
  while (const auto pair = queue_.next())
    merge (pair->first, pair->second);
}

void
Merger::writeBack()
{
  for (int& body : state_.body_of)
    body = queue_.partOf (body);
  const std::vector<int> before = state_.renumberBodies();
  for (std::size_t b = 0; b < before.size(); ++b)
    if (queue_.hasGrown (before[b]))
      for (std::size_t p = 0; p < terms_.size(); ++p)
        Eigen::Map<Vector6> (state_.poses[terms_[p].pair][b].parameters.data()) =
            bodies_[before[b]].pairs[p].best;
}

void
Merger::run()
{
  mergeQueued();
  while (considerLargest())
    mergeQueued();
  writeBack();
}

} // namespace

void
mergeBodies (const std::vector<PairTerms>& terms,
             int frames,
             const std::vector<SegmentLink>& links,
             const MergeTuning& tuning,
             WindowState& state)
{
  Merger (terms, frames, links, tuning, state).run();
}

} // namespace pcl_msf
