// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_solve.h"

#include "core/base/parallel_for.h"
#include "core/points/loose_ends.h"
#include "core/points/segment_start.h"
#include "core/surface/thinning.h"

#include <algorithm>
#include <array>
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

/** All cuts but the last are only for the samples, and made of them. */
std::vector<SampleCut>
cutCoarsely (const WorkingCloud& cloud, const Tuning& tuning)
{
  std::vector<SampleCut> cuts;
  for (std::size_t s = 0; s + 1 < tuning.points.stages.size(); ++s) {
    SampleCut cut;
    cut.segments = cutSurface (cloud.thin,
                               tuning.points.stages[s].segments,
                               cuts.empty() ? std::vector<int>() : cuts.back().seeds,
                               tuning.surface);
    cut.seeds = cut.segments.seeds;
    cut.label = cut.segments.label;
    cut.members = cut.segments.members;
    cuts.push_back (std::move (cut));
  }
  return cuts;
}

/** The last cut is of all points. */
SampleCut
cutFinely (const WorkingCloud& cloud,
           const std::vector<int>& coarse_seeds,
           const Tuning& tuning)
{
  std::vector<int> seeds;
  for (const int seed : coarse_seeds)
    seeds.push_back (cloud.samples[seed]);
  SampleCut cut;
  cut.segments = cutSurface (
      cloud.surface, tuning.points.stages.back().segments, seeds, tuning.surface);
  const PointTree tree (cloud.thin.points);
  for (const int seed : cut.segments.seeds)
    cut.seeds.push_back (tree.nearest (cloud.surface.points[seed]).index);
  for (const int sample : cloud.samples) {
    cut.label.push_back (cut.segments.label[sample]);
    cut.members.push_back (cut.segments.members[sample]);
  }
  return cut;
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
  cuts_ = cutCoarsely (clouds.source, tuning);
  cuts_.push_back (cutFinely (clouds.source, cuts_.back().seeds, tuning));
  samples_.points = clouds.source.thin.points;
  samples_.normals = clouds.source.thin.normals;
  poses_.assign (cuts_[0].segments.size(), start);
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
  samples_.members = cuts_[cut].members;
}

/** \param pairs of sample and point of the thin target that pull, too, less and less */
void
PointSolve::match (const PointStage& stage,
                   MatchTarget& target,
                   const std::vector<PointPair>& pairs)
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
    std::vector<PointPull> pulls = target.pulls (moved, rules, threads_);
    addPairs (moved, pairs, tuning_.limbs.to, tuning_.limbs.hold * (1.0 - f), pulls);
    const double cost = problem.step (pulls, tuning_.match.iterations);
    progress_.note (static_cast<int> (cuts_.size()) - 1 - cut_, cost, "match");
  }
}

/** From where the clouds lie on each other, by the distances along the surfaces. */
std::vector<PointPair>
PointSolve::isometricPairs (const LimbAnchors& anchors)
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
  for (const int place : spreadPoints (source.points, places, anchors.count))
    candidates.push_back (tight[place]);
  const SurfaceIsometry isometry (
      source, target, candidates, 1.0, anchors.agreement, tuning_.isometry, threads_);
  return isometry.match (everySo (source.size(), tuning_.limbs.source_points),
                         everySo (target.size(), tuning_.limbs.target_points),
                         threads_);
}

/** Adds pulls along pairs, robustly. \param share of all of them together, of a pull
 * per sample */
void
PointSolve::addPairs (const MovedPoints& moved,
                      const std::vector<PointPair>& pairs,
                      double scale,
                      double share,
                      std::vector<PointPull>& pulls) const
{
  if (!(share > 0.0))
    return;
  const double each = share * samples_.size() /
                      static_cast<double> (std::max<std::size_t> (1, pairs.size()));
  for (const PointPair& pair : pairs) {
    const Eigen::Vector3f& q = clouds_.target.thin.points[pair.target];
    const double d2 = (moved.points[pair.source] - q).squaredNorm();
    const double g = scale * scale / (scale * scale + d2);
    pulls[pair.source].add (
        q.cast<double>(), Eigen::Vector3d::Zero(), each * pair.weight * g * g, 1.0);
  }
}

/** \param pairs of sample and point of the thin target */
void
PointSolve::followPairs (const std::vector<PointPair>& pairs)
{
  const LimbTuning& limbs = tuning_.limbs;
  startSegments (samples_, clouds_.target.thin.points, pairs, limbs.to, limbs, poses_);
  PointEnergyWeights weights;
  weights.regularizer = limbs.regularizer;
  weights.unit = segments().radius;
  PointProblem problem (samples_, segments(), weights, threads_, poses_);
  for (int i = 0; i < limbs.steps && !progress_.stopped(); ++i) {
    const MovedPoints moved = movePoints (samples_, poses_, threads_);
    const double scale =
        limbs.from * std::pow (limbs.to / limbs.from, i / (limbs.steps - 1.0));
    std::vector<PointPull> pulls (samples_.size());
    addPairs (moved, pairs, scale, 1.0, pulls);
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

/** What the pairs are wrong about is found by matches from far. \return may it lead to
 * more than what was found before? */
bool
PointSolve::startAnew (const std::vector<PointPair>& pairs)
{
  enter (tuning_.limbs.cut);
  followPairs (pairs);
  PointStage stage = tuning_.stages[tuning_.limbs.cut];
  stage.from = std::max (stage.from, tuning_.limbs.match_from);
  match (stage, coarse_, pairs);
  const double now = explained();
  const bool hopeful = now >= (1.0 - tuning_.limbs.hopeless) * promised_;
  promised_ = std::max (promised_, now);
  return hopeful;
}

/** Share of the pairs that lie elsewhere. */
double
PointSolve::disputed (const std::vector<PointPair>& pairs) const
{
  const MovedPoints moved = movePoints (samples_, poses_, threads_);
  double all = 0.0;
  double elsewhere = 0.0;
  for (const PointPair& pair : pairs) {
    const Eigen::Vector3f& q = clouds_.target.thin.points[pair.target];
    all += pair.weight;
    if ((moved.points[pair.source] - q).norm() > tuning_.limbs.elsewhere)
      elsewhere += pair.weight;
  }
  return all > 0.0 ? elsewhere / all : 0.0;
}

/** Is all of one cloud on the other, and no limb where it should not be? */
bool
PointSolve::allCovered()
{
  const MovedPoints moved = movePoints (samples_, poses_, threads_);
  const double spacing = std::max (clouds_.source.surface.median_spacing,
                                   clouds_.target.surface.median_spacing);
  const double near = std::max (tuning_.result.found * spacing,
                                2.0 * clouds_.source.thin.median_spacing);
  const Coverage coverage =
      fine_.covered (moved, tightRules (tuning_.match), near, threads_);
  if (1.0 - std::max (coverage.movedShare(), coverage.samplesShare()) >
          tuning_.limbs.uncovered ||
      meanGap (segments(), poses_) > tuning_.result.gap)
    return false;
  const std::vector<char> places =
      coveredPlaces (clouds_.target.thin, moved, near, threads_);
  return largestLooseEnd (clouds_, moved.points, places, tuning_.result.border) <
         tuning_.result.loose;
}

/** One fresh start, kept when it explains more. \return does it explain much more? */
bool
PointSolve::tryAgain (const std::vector<PointPair>& pairs)
{
  const int last = static_cast<int> (cuts_.size()) - 1;
  const std::vector<RigidPose> before = poses_;
  const double reached = explained();
  double now = 0.0;
  const bool hopeful = startAnew (pairs);
  enter (last);
  if (hopeful) {
    match (tuning_.stages[last], fine_);
    now = explained();
  }
  if (now < reached)
    poses_ = before;
  return now >= (1.0 + tuning_.limbs.gain) * reached;
}

/** Starts anew from what the distances along the surfaces say, with many anchors, fewer
 * or the surest alone, until each has led to nothing more. What is covered already is
 * left as it is when the distances agree, or a fresh start has not made it better. */
void
PointSolve::seekLimbs()
{
  const LimbTuning& limbs = tuning_.limbs;
  const double agreement = tuning_.isometry.agreement;
  const std::array<LimbAnchors, 3> kinds{
      LimbAnchors{limbs.fewer_anchors, agreement},
      LimbAnchors{limbs.anchors, tuning_.isometry.sure_agreement},
      LimbAnchors{limbs.anchors, agreement}};
  std::size_t failures = 0; // one after the other
  std::size_t kind = 0;
  for (int round = 0; round < limbs.rounds && !progress_.stopped(); ++round) {
    const bool covered = allCovered();
    if (covered && failures > 0)
      break;
    const std::vector<PointPair> pairs = isometricPairs (kinds[kind]);
    if (covered && disputed (pairs) < limbs.disputed)
      break;
    if (tryAgain (pairs)) {
      failures = 0;
      continue;
    }
    if (++failures >= kinds.size())
      break;
    kind = (kind + 1) % kinds.size();
  }
}

void
PointSolve::run()
{
  const int last = static_cast<int> (tuning_.stages.size()) - 1;
  for (int c = 0; c <= last && !progress_.stopped(); ++c) {
    enter (c);
    match (tuning_.stages[c], c == last ? fine_ : coarse_);
    if (c == tuning_.limbs.cut)
      promised_ = explained();
  }
  seekLimbs();
  if (cut_ != last) // stopped
    enter (last);
}

} // namespace pcl_msf
