// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_solve.h"

#include "core/base/parallel_for.h"
#include "core/points/segment_start.h"
#include "core/surface/thinning.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_msf {

namespace {

MatchRules
tightRules (const PointMatchTuning& tuning)
{
  MatchRules rules;
  rules.distance = tuning.tight;
  rules.normal_length = tuning.tight_normal;
  rules.least = tuning.tight_weight;
  return rules;
}

std::vector<int>
allOf (const Surface& surface)
{
  std::vector<int> all (surface.size());
  std::iota (all.begin(), all.end(), 0);
  return all;
}

/** Every so manieth of n, `count` at the most. */
std::vector<int>
everySo (int n, int count)
{
  std::vector<int> chosen;
  const int step = std::max (1, (n + count - 1) / count);
  for (int i = 0; i < n; i += step)
    chosen.push_back (i);
  return chosen;
}

} // namespace

PointSolve::PointSolve (const PointClouds& clouds,
                        const RigidPose& start,
                        const Tuning& tuning,
                        int threads,
                        SolveProgress& progress)
: clouds_ (clouds)
, tuning_ (tuning.points)
, threads_ (threads)
, progress_ (progress)
, coarse_ (clouds.target.thin, allOf (clouds.target.thin))
, fine_ (clouds.target.surface, clouds.target.samples)
{
  for (const PointStage& stage : tuning_.stages)
    cuts_.push_back (
        cutSurface (clouds.source.surface,
                    stage.segments,
                    cuts_.empty() ? std::vector<int>() : cuts_.back().seeds,
                    tuning.surface));
  poses_.assign (cuts_[0].size(), start);
  enter (0);
}

/** Segments of the new cut begin as those that their seeds lie in. */
void
PointSolve::enter (int cut)
{
  std::vector<RigidPose> poses;
  for (const int seed : cuts_[cut].seeds)
    poses.push_back (poses_[cuts_[cut_].label[seed]]);
  poses_ = std::move (poses);
  cut_ = cut;
  samples_ = {};
  const Surface& surface = clouds_.source.surface;
  for (const int i : clouds_.source.samples) {
    samples_.points.push_back (surface.points[i]);
    samples_.normals.push_back (surface.normals[i]);
    samples_.members.push_back (segments().members[i]);
  }
}

void
PointSolve::match (const PointStage& stage, MatchTarget& target)
{
  PointEnergyWeights weights;
  weights.regularizer = stage.regularizer;
  weights.unit = segments().radius;
  PointProblem problem (samples_, segments(), weights, threads_, poses_);
  for (int i = 0; i < stage.steps && !progress_.stopped(); ++i) {
    const double f = i / std::max (1.0, stage.steps - 1.0);
    MatchRules rules;
    rules.distance = stage.from * std::pow (stage.to / stage.from, f);
    rules.normal_length = std::max (tuning_.match.normal_length * rules.distance,
                                    tuning_.match.least_normal);
    rules.isotropy = tuning_.match.isotropy;
    rules.mutual = std::max (rules.distance, tuning_.match.least_mutual);
    rules.backward = tuning_.match.backward;
    const MovedPoints moved = movePoints (samples_, poses_, threads_);
    const double cost =
        problem.step (target.pulls (moved, rules, threads_), tuning_.match.iterations);
    progress_.note (static_cast<int> (cuts_.size()) - 1 - cut_, cost, "match");
  }
}

/** From where the clouds lie on each other, by the distances along the surfaces. */
std::vector<PointPair>
PointSolve::isometricPairs()
{
  const MovedPoints moved = movePoints (samples_, poses_, threads_);
  const std::vector<PointPair> tight =
      coarse_.tightPairs (moved, tightRules (tuning_.match), threads_);
  const Surface& source = clouds_.source.thin;
  const Surface& target = clouds_.target.thin;
  std::vector<int> places;
  for (const PointPair& pair : tight)
    places.push_back (pair.source);
  std::vector<PointPair> candidates;
  for (const int place : spreadPoints (source.points, places, tuning_.limbs.anchors))
    candidates.push_back (tight[place]);
  const SurfaceIsometry isometry (
      source, target, candidates, 1.0, tuning_.isometry, threads_);
  return isometry.match (everySo (source.size(), tuning_.limbs.source_points),
                         everySo (target.size(), tuning_.limbs.target_points),
                         threads_);
}

/** \param pairs of sample and point of the thin target */
void
PointSolve::followPairs (const std::vector<PointPair>& pairs)
{
  const LimbTuning& limbs = tuning_.limbs;
  std::vector<PointPair> given = pairs;
  for (PointPair& pair : given)
    pair.source = clouds_.source.samples[pair.source];
  startSegments (clouds_.source.surface,
                 clouds_.target.thin,
                 segments(),
                 given,
                 limbs.to,
                 limbs,
                 poses_);
  PointEnergyWeights weights;
  weights.regularizer = limbs.regularizer;
  weights.unit = segments().radius;
  weights.data = static_cast<double> (samples_.size()) /
                 std::max (1, std::min (limbs.source_points, samples_.size()));
  PointProblem problem (samples_, segments(), weights, threads_, poses_);
  for (int i = 0; i < limbs.steps && !progress_.stopped(); ++i) {
    const MovedPoints moved = movePoints (samples_, poses_, threads_);
    const double scale =
        limbs.from * std::pow (limbs.to / limbs.from, i / (limbs.steps - 1.0));
    std::vector<PointPull> pulls (samples_.size());
    for (const PointPair& pair : pairs) {
      const Eigen::Vector3f& q = clouds_.target.thin.points[pair.target];
      const double d2 = (moved.points[pair.source] - q).squaredNorm();
      const double g = scale * scale / (scale * scale + d2);
      pulls[pair.source].add (
          q.cast<double>(), Eigen::Vector3d::Zero(), pair.weight * g * g, 1.0);
    }
    progress_.note (static_cast<int> (cuts_.size()) - 1 - cut_,
                    problem.step (pulls, tuning_.match.iterations),
                    "limbs");
  }
}

double
PointSolve::explained()
{
  const auto [source, target] = coarse_.explained (
      movePoints (samples_, poses_, threads_), tightRules (tuning_.match), threads_);
  return source + target;
}

void
PointSolve::run()
{
  const int last = static_cast<int> (tuning_.stages.size()) - 1;
  for (int c = 0; c <= last && !progress_.stopped(); ++c) {
    enter (c);
    match (tuning_.stages[c], c == last ? fine_ : coarse_);
  }
  for (int round = 0; round < tuning_.limbs.rounds && !progress_.stopped(); ++round) {
    const std::vector<RigidPose> before = poses_;
    const double reached = explained();
    const std::vector<PointPair> pairs = isometricPairs();
    enter (tuning_.limbs.cut);
    followPairs (pairs);
    match (tuning_.stages[tuning_.limbs.cut], coarse_);
    enter (last);
    match (tuning_.stages[last], fine_);
    const double now = explained();
    if (now < reached)
      poses_ = before;
    if (now < (1.0 + tuning_.limbs.gain) * reached)
      break;
  }
}

} // namespace pcl_msf
