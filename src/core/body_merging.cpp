// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/body_merging.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>

namespace pcl_msf {

namespace {

constexpr int kLargest = 6; // bodies that every other one may join

/** E (x) = 1/2 x' A x - h' x + const over the six pose parameters. */
struct BodyQuadratic {
  Matrix6 a{Matrix6::Zero()};
  Vector6 h{Vector6::Zero()};
  Vector6 prior{Vector6::Zero()}; ///< where to stay when A does not decide
  int points{0};
  double minimum{0.0};
  Vector6 best{Vector6::Zero()};
  int version{0};
  bool alive{false}; ///< has segments and was not merged into another
  std::set<int> neighbors;

  void
  solve ()
  {
    Matrix6 m = a;
    const double ridge = 1e-9 * a.trace() + 1e-15;
    m.diagonal().array() += ridge;
    const Vector6 rhs = h + ridge * prior;
    best = m.ldlt().solve (rhs);
    minimum = 0.5 * best.dot (a * best) - h.dot (best);
  }
};

class Merger {
public:
  Merger (const DataTerm& data,
          const std::vector<SegmentLink>& links,
          const MergeRules& rules,
          const MotionState& state);

  MotionState
  run ();

private:
  struct Edge {
    double increase;
    int first, second;
    int first_version, second_version;
    bool
    operator<(const Edge& other) const // the cheapest on top, ties by index
    {
      return std::tie (increase, first, second) >
             std::tie (other.increase, other.first, other.second);
    }
  };

  static BodyQuadratic
  sum (const BodyQuadratic& a, const BodyQuadratic& b);
  void
  consider (int a, int b);
  void
  merge (int a, int b);
  void
  mergeQueued ();
  bool
  considerLargest ();

  MergeRules rules_;
  MotionState state_;
  std::vector<BodyQuadratic> bodies_;
  std::vector<int> joined_; ///< body -> the one that it went into
  std::priority_queue<Edge> queue_;
};

Merger::Merger (const DataTerm& data,
                const std::vector<SegmentLink>& links,
                const MergeRules& rules,
                const MotionState& state)
: rules_ (rules)
, state_ (state)
, bodies_ (state.poses.size())
, joined_ (state.poses.size())
{
  std::iota (joined_.begin(), joined_.end(), 0);
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    bodies_[b].prior = Eigen::Map<const Vector6> (state.poses[b].parameters.data());
  for (std::size_t k = 0; k < state.body_of.size(); ++k) {
    BodyQuadratic& body = bodies_[state.body_of[k]];
    const SegmentQuadratic& q = data.of (static_cast<int> (k));
    body.a += q.information;
    body.h += q.information * body.prior - q.gradient;
    body.points += data.pixels().size (static_cast<int> (k));
    body.alive = true;
  }
  for (BodyQuadratic& body : bodies_)
    body.solve();
  for (const SegmentLink& link : links) {
    const int a = state.body_of[link.first];
    const int b = state.body_of[link.second];
    if (a == b)
      continue;
    bodies_[a].neighbors.insert (b);
    bodies_[b].neighbors.insert (a);
  }
  for (std::size_t a = 0; a < bodies_.size(); ++a)
    for (const int b : bodies_[a].neighbors)
      if (static_cast<int> (a) < b)
        consider (static_cast<int> (a), b);
}

BodyQuadratic
Merger::sum (const BodyQuadratic& a, const BodyQuadratic& b)
{
  BodyQuadratic result;
  result.alive = true;
  result.a = a.a + b.a;
  result.h = a.h + b.h;
  result.points = a.points + b.points;
  result.prior = a.points >= b.points ? a.best : b.best;
  result.solve();
  return result;
}

void
Merger::consider (int a, int b)
{
  const BodyQuadratic& first = bodies_[a];
  const BodyQuadratic& second = bodies_[b];
  const double increase =
      (sum (first, second).minimum - first.minimum - second.minimum) *
      rules_.residual_scale;
  const double allowed =
      rules_.allowance + rules_.per_point * std::min (first.points, second.points);
  if (increase < allowed)
    queue_.push ({increase, a, b, first.version, second.version});
}

void
Merger::merge (int a, int b)
{
  BodyQuadratic merged = sum (bodies_[a], bodies_[b]);
  merged.version = bodies_[a].version + 1;
  merged.neighbors = bodies_[a].neighbors;
  merged.neighbors.insert (bodies_[b].neighbors.begin(), bodies_[b].neighbors.end());
  merged.neighbors.erase (a);
  merged.neighbors.erase (b);
  bodies_[b].alive = false;
  joined_[b] = a;
  for (const int n : merged.neighbors) {
    bodies_[n].neighbors.erase (b);
    bodies_[n].neighbors.insert (a);
  }
  bodies_[a] = std::move (merged);
  for (const int n : bodies_[a].neighbors)
    consider (std::min (a, n), std::max (a, n));
}

/** Offers every body to the largest ones, which it may not touch: furniture in front of
 * a wall has only itself as neighbours. \return whether there is anything to merge */
bool
Merger::considerLargest()
{
  std::vector<int> order;
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    if (bodies_[b].alive)
      order.push_back (static_cast<int> (b));
  std::stable_sort (order.begin(), order.end(), [&] (int a, int b) {
    return bodies_[a].points > bodies_[b].points;
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = 0; j < std::min<std::size_t> (i, kLargest); ++j)
      consider (std::min (order[i], order[j]), std::max (order[i], order[j]));
  return !queue_.empty();
}

void
Merger::mergeQueued()
{
  while (!queue_.empty()) {
    const Edge e = queue_.top();
    queue_.pop();
    const BodyQuadratic& first = bodies_[e.first];
    const BodyQuadratic& second = bodies_[e.second];
    if (first.alive && second.alive && first.version == e.first_version &&
        second.version == e.second_version)
      merge (e.first, e.second);
  }
}

MotionState
Merger::run()
{
  mergeQueued();
  while (considerLargest())
    mergeQueued();
  MotionState result = state_;
  result.poses.clear();
  std::vector<int> index (bodies_.size(), -1);
  for (int& body : result.body_of) {
    while (joined_[body] != body)
      body = joined_[body];
    if (index[body] < 0) {
      index[body] = static_cast<int> (result.poses.size());
      RigidPose pose = state_.poses[body];
      if (bodies_[body].version > 0)
        Eigen::Map<Vector6> (pose.parameters.data()) = bodies_[body].best;
      result.poses.push_back (pose);
    }
    body = index[body];
  }
  return result;
}

} // namespace

MotionState
mergeBodies (const DataTerm& data,
             const std::vector<SegmentLink>& links,
             const MergeRules& rules,
             const MotionState& state)
{
  return Merger (data, links, rules, state).run();
}

} // namespace pcl_msf
