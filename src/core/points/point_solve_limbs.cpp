// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/loose_ends.h"
#include "core/points/point_solve.h"
#include "core/points/segment_start.h"
#include "core/surface/thinning.h"

#include <algorithm>
#include <array>
#include <cmath>

/* Limbs that moved far. */
namespace pcl_msf {

namespace {

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

/** From where the clouds lie on each other, by the distances along the surfaces. */
std::vector<PointPair>
PointSolve::isometricPairs (const LimbAnchors& anchors)
{
  const MovedPoints moved = movePoints (samples_, poses_, threads_);
  const std::vector<PointPair> tight =
      coarse_.tightPairs (moved, tightRules(), threads_);
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

/** Without matches. \param pairs of sample and point of the thin target, with which the
 * known ones pull; none = these alone */
void
PointSolve::followPairs (const std::vector<PointPair>& pairs)
{
  const LimbTuning& limbs = tuning_.limbs;
  const std::vector<RigidPose> before = poses_;
  startSegments (samples_, clouds_.target.thin.points, pairs, limbs.to, limbs, poses_);
  for (int k = 0; k < segments().size(); ++k)
    if (segments().isFixed (k))
      poses_[k] = before[k];
  PointEnergyWeights weights;
  weights.regularizer = limbs.regularizer;
  weights.unit = segments().radius;
  PointTerms terms (samples_, known_, segments(), weights, threads_, poses_);
  PointProblem problem;
  problem.add (terms);
  for (int i = 0; i < limbs.steps && !progress_.stopped(); ++i) {
    const MovedPoints moved = movePoints (samples_, poses_, threads_);
    const double scale =
        limbs.from * std::pow (limbs.to / limbs.from, i / (limbs.steps - 1.0));
    std::vector<PointPull> pulls (samples_.size());
    addPairs (moved, pairs, scale, 1.0, pulls);
    addKnown (1.0, pulls);
    terms.take (pulls);
    progress_.note (static_cast<int> (cuts_.size()) - 1 - cut_,
                    problem.step (tuning_.match.iterations),
                    "limbs");
  }
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
  const bool may_gain = now >= (1.0 - tuning_.limbs.early_end) * most_explained_;
  most_explained_ = std::max (most_explained_, now);
  return may_gain;
}

/** Share of the pairs that lie elsewhere. */
double
PointSolve::conflicting (const std::vector<PointPair>& pairs) const
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

/** See found. */
bool
PointSolve::allCovered()
{
  const MovedPoints moved = movePoints (samples_, poses_, threads_);
  const double spacing = std::max (clouds_.source.surface.median_spacing,
                                   clouds_.target.surface.median_spacing);
  const double near = std::max (tuning_.result.found * spacing,
                                2.0 * clouds_.source.thin.median_spacing);
  if (meanGap (segments(), poses_) > tuning_.result.gap)
    return false;
  const SelfOverlapTuning& overlap = tuning_.result.overlap;
  if (selfOverlap (clouds_.source.thin, moved, overlap, threads_) > overlap.most)
    return false;
  const Coverage coverage = fine_.covered (moved, tightRules(), near, threads_);
  if (1.0 - std::max (coverage.movedShare(), coverage.samplesShare()) >
      tuning_.limbs.uncovered)
    return false;
  const CloudEnds ends =
      looseEnds (clouds_, moved, moved, near, tuning_.result, threads_);
  return ends.target.largest < tuning_.result.loose;
}

/** One fresh start, kept when it explains more. \return does it explain much more? */
bool
PointSolve::tryAgain (const std::vector<PointPair>& pairs)
{
  const int last = static_cast<int> (cuts_.size()) - 1;
  const std::vector<RigidPose> before = poses_;
  const double reached = explained();
  double now = 0.0;
  const bool may_gain = startAnew (pairs);
  enter (last);
  if (may_gain) {
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
    if (covered && conflicting (pairs) < limbs.conflicting)
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

} // namespace pcl_msf
