// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Cholesky>

#include "core/multi_frame_bodies.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>

namespace pcl_msf {

namespace {

/** E (x) = 1/2 x' A x - h' x + const over the six pose parameters of a pair. */
struct PairQuadratic {
  Matrix6 a{Matrix6::Zero()};
  Vector6 h{Vector6::Zero()};
  Vector6 best{Vector6::Zero()}; ///< its minimum, near the prior where A says nothing

  double
  solve (const Vector6& prior)
  {
    Matrix6 m = a;
    const double ridge = 1e-9 * a.trace() + 1e-15;
    m.diagonal().array() += ridge;
    best = m.ldlt().solve (h + ridge * prior);
    return 0.5 * best.dot (a * best) - h.dot (best);
  }
};

/** A body's quadratics in all pairs, in squared deviations. */
struct Trajectory {
  std::vector<PairQuadratic> pairs;
  int points{0};
  double minimum{0.0};
  int version{0};
  bool alive{true};
  std::set<int> neighbors;
};

Trajectory
sum (const Trajectory& a, const Trajectory& b)
{
  Trajectory result;
  result.points = a.points + b.points;
  const Trajectory& larger = a.points >= b.points ? a : b;
  for (std::size_t p = 0; p < a.pairs.size(); ++p) {
    PairQuadratic q;
    q.a = a.pairs[p].a + b.pairs[p].a;
    q.h = a.pairs[p].h + b.pairs[p].h;
    result.minimum += q.solve (larger.pairs[p].best);
    result.pairs.push_back (q);
  }
  return result;
}

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

class TrajectoryMerger {
public:
  TrajectoryMerger (const MultiFrameLevel& level,
                    const MultiFrameScene& scene,
                    const EnergyParameters& energy,
                    const MergeRules& rules,
                    MultiFrameState& state);
  void
  run ();

private:
  void
  addPair (const DataTerm& data, const EnergyParameters& energy, int slot, int pair);
  void
  consider (int a, int b);
  void
  merge (int a, int b);
  void
  writeBack ();

  const MultiFrameScene& scene_;
  MergeRules rules_;
  MultiFrameState& state_;
  std::vector<Trajectory> bodies_;
  std::vector<int> joined_;
  std::priority_queue<Edge> queue_;
};

TrajectoryMerger::TrajectoryMerger (const MultiFrameLevel& level,
                                    const MultiFrameScene& scene,
                                    const EnergyParameters& energy,
                                    const MergeRules& rules,
                                    MultiFrameState& state)
: scene_ (scene)
, rules_ (rules)
, state_ (state)
, bodies_ (state.bodies())
, joined_ (state.bodies())
{
  std::iota (joined_.begin(), joined_.end(), 0);
  for (Trajectory& body : bodies_)
    body.pairs.resize (scene.used.size());
  for (std::size_t slot = 0; slot < scene.used.size(); ++slot)
    addPair (level.data (scene.used[slot]),
             energy,
             static_cast<int> (slot),
             scene.used[slot]);
  const SegmentPixels& pixels = level.pixels (scene.pairs.reference());
  for (std::size_t k = 0; k < state.body_of.size(); ++k)
    bodies_[state.body_of[k]].points += pixels.size (static_cast<int> (k));
  for (const SegmentLink& link : scene.links) {
    const int a = state.body_of[link.first];
    const int b = state.body_of[link.second];
    if (a == b)
      continue;
    bodies_[a].neighbors.insert (b);
    bodies_[b].neighbors.insert (a);
  }
  for (int a = 0; a < state.bodies(); ++a)
    for (const int b : bodies_[a].neighbors)
      if (a < b)
        consider (a, b);
}

void
TrajectoryMerger::addPair (const DataTerm& data,
                           const EnergyParameters& energy,
                           int slot,
                           int pair)
{
  const double scale = residualScale (energy, data.pixels());
  for (std::size_t k = 0; k < state_.body_of.size(); ++k) {
    const int b = state_.body_of[k];
    const Eigen::Map<const Vector6> pose (state_.poses[pair][b].parameters.data());
    const SegmentQuadratic& q = data.of (static_cast<int> (k));
    bodies_[b].pairs[slot].a += scale * q.information;
    bodies_[b].pairs[slot].h += scale * (q.information * pose - q.gradient);
  }
  for (int b = 0; b < state_.bodies(); ++b)
    bodies_[b].minimum += bodies_[b].pairs[slot].solve (
        Eigen::Map<const Vector6> (state_.poses[pair][b].parameters.data()));
}

void
TrajectoryMerger::consider (int a, int b)
{
  const Trajectory& first = bodies_[a];
  const Trajectory& second = bodies_[b];
  const double increase = sum (first, second).minimum - first.minimum - second.minimum;
  // Pairs share their frames' noise: N frames hold N - 1 independent motions.
  const double allowed =
      std::sqrt (scene_.pairs.frames() - 1.0) *
      (rules_.allowance + rules_.per_point * std::min (first.points, second.points));
  if (increase < allowed)
    queue_.push ({increase, a, b, first.version, second.version});
}

void
TrajectoryMerger::merge (int a, int b)
{
  Trajectory merged = sum (bodies_[a], bodies_[b]);
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

void
TrajectoryMerger::run()
{
  while (!queue_.empty()) {
    const Edge e = queue_.top();
    queue_.pop();
    const Trajectory& first = bodies_[e.first];
    const Trajectory& second = bodies_[e.second];
    if (first.alive && second.alive && first.version == e.first_version &&
        second.version == e.second_version)
      merge (e.first, e.second);
  }
  writeBack();
}

void
TrajectoryMerger::writeBack()
{
  const auto old = state_.poses;
  for (auto& poses : state_.poses)
    poses.clear();
  std::vector<int> index (bodies_.size(), -1);
  int next = 0;
  for (int& body : state_.body_of) {
    while (joined_[body] != body)
      body = joined_[body];
    if (index[body] < 0) {
      index[body] = next++;
      for (std::size_t p = 0; p < old.size(); ++p)
        state_.poses[p].push_back (old[p][body]);
      if (bodies_[body].version > 0)
        for (std::size_t slot = 0; slot < scene_.used.size(); ++slot)
          Eigen::Map<Vector6> (
              state_.poses[scene_.used[slot]].back().parameters.data()) =
              bodies_[body].pairs[slot].best;
    }
    body = index[body];
  }
}

} // namespace

void
mergeTrajectories (const MultiFrameLevel& level,
                   const MultiFrameScene& scene,
                   const EnergyParameters& energy,
                   const MergeRules& rules,
                   MultiFrameState& state)
{
  TrajectoryMerger (level, scene, energy, rules, state).run();
}

} // namespace pcl_msf
