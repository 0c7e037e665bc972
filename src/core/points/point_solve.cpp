// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_solve.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_msf {

namespace {

std::vector<int>
allOf (const Surface& surface)
{
  std::vector<int> all (surface.size());
  std::iota (all.begin(), all.end(), 0);
  return all;
}

} // namespace

PointSolve::PointSolve (const PointClouds& clouds,
                        const PriorKnowledge& prior,
                        const RigidPose& start,
                        const Tuning& tuning,
                        int threads,
                        SolveProgress& progress)
: clouds_ (clouds)
, prior_ (prior)
, tuning_ (tuning.points)
, threads_ (threads)
, progress_ (progress)
, cuts_ (cutSamples (clouds.source, prior.fixed, tuning))
, coarse_ (clouds.target.thin, allOf (clouds.target.thin), clouds.target.thin_texture)
, fine_ (clouds.target.surface, clouds.target.samples, clouds.target.texture)
{
  samples_.points = clouds.source.thin.points;
  samples_.normals = clouds.source.thin.normals;
  for (const KnownPoint& known : prior.points) {
    known_.points.push_back (known.point);
    known_.normals.push_back (clouds.source.surface.normals[known.place]);
  }
  poses_.assign (cuts_[0].segments.size(), start);
  free_ = prior.points.empty() && prior.guesses.empty() && prior.fixed.empty() &&
          clouds.source.segment.empty();
  for (const auto& [segment, pose] : prior.guesses)
    poses_[segment] = pose;
  enter (0);
}

void
PointSolve::beginAt (const std::vector<RigidPose>& poses)
{
  poses_ = poses;
  free_ = false;
  cut_ = static_cast<int> (cuts_.size()) - 1;
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
  const bool all = segments().members.size() == clouds_.source.given.size();
  known_.members.clear();
  for (const KnownPoint& known : prior_.points)
    known_.members.push_back (all ? segments().members[known.place]
                                  : samples_.members[known.sample]);
}

/** The samples are as bright as their surroundings that are as large as the target's.
 */
void
PointSolve::takeBrightness (const MatchTarget& target)
{
  const WorkingCloud& source = clouds_.source;
  samples_.brightness.clear();
  if (&target == &coarse_)
    samples_.brightness = source.thin_texture.value;
  else if (!source.texture.value.empty())
    for (const int i : source.samples)
      samples_.brightness.push_back (source.texture.value[i]);
}

/** \param pairs of sample and point of the thin target that pull, too, less and less */
void
PointSolve::match (const PointStage& stage,
                   MatchTarget& target,
                   const std::vector<PointPair>& pairs)
{
  takeBrightness (target);
  PointEnergyWeights weights;
  weights.regularizer = stage.regularizer;
  weights.unit = segments().radius;
  PointTerms terms (samples_, known_, segments(), weights, threads_, poses_);
  PointProblem problem;
  problem.add (terms);
  for (int i = 0; i < stage.steps && !progress_.stopped(); ++i) {
    const double f = i / std::max (1.0, stage.steps - 1.0);
    const MatchRules rules = rulesOf (stage.from * std::pow (stage.to / stage.from, f));
    const MovedPoints moved = movePoints (samples_, poses_, threads_);
    std::vector<PointPull> pulls = target.pulls (moved, rules, threads_);
    prior_.weigh (clouds_.source.samples, pulls);
    addPairs (moved, pairs, tuning_.limbs.to, tuning_.limbs.hold * (1.0 - f), pulls);
    addKnown (rules.distance / tuning_.stages[0].from, pulls);
    terms.take (pulls);
    const double cost = problem.step (tuning_.match.iterations);
    progress_.note (static_cast<int> (cuts_.size()) - 1 - cut_, cost, "match");
  }
}

std::vector<PointPull>
PointSolve::finePulls (double distance)
{
  takeBrightness (fine_);
  const MatchRules rules = rulesOf (distance);
  std::vector<PointPull> pulls =
      fine_.pulls (movePoints (samples_, poses_, threads_), rules, threads_);
  prior_.weigh (clouds_.source.samples, pulls);
  addKnown (distance / tuning_.stages[0].from, pulls);
  return pulls;
}

MatchRules
PointSolve::rulesOf (double distance) const
{
  MatchRules rules;
  rules.distance = distance;
  rules.normal_length =
      std::max (tuning_.match.normal_length * distance, tuning_.match.least_normal);
  rules.isotropy = tuning_.match.isotropy;
  rules.mutual = std::max (distance, tuning_.match.least_mutual);
  rules.backward = tuning_.match.backward;
  rules.brightness = distance;
  rules.brightness_weight = tuning_.brightness.weight;
  rules.outlying = tuning_.brightness.outlying;
  return rules;
}

bool
PointSolve::brightnessAgrees()
{
  const bool fine = clouds_.target.texture.varies();
  if (!fine && !clouds_.target.thin_texture.varies())
    return true;
  MatchTarget& target = fine ? fine_ : coarse_;
  takeBrightness (target);
  target.pulls (movePoints (samples_, poses_, threads_),
                rulesOf (tuning_.stages.back().to),
                threads_);
  return target.brightnessAgreement() >= tuning_.brightness.agreement;
}

/** Of pairs that are surely right. */
MatchRules
PointSolve::tightRules() const
{
  MatchRules rules;
  rules.distance = tuning_.match.tight;
  rules.normal_length = tuning_.match.tight_normal;
  rules.least = tuning_.match.tight_weight;
  return rules;
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

/** Adds pulls at the known points after those at the samples.
 * \param share of a segment's matches that a pair of weight 1 counts as: the pairs lead
 * to where matches are right and then leave it to these */
void
PointSolve::addKnown (double share, std::vector<PointPull>& pulls) const
{
  const double unit = share * static_cast<double> (samples_.size()) / segments().size();
  for (const KnownPoint& known : prior_.points)
    pulls.push_back (known.pull (unit));
}

double
PointSolve::explained()
{
  std::vector<float> weights;
  for (std::size_t s = 0; s < clouds_.source.samples.size() && !prior_.weights.empty();
       ++s)
    weights.push_back (prior_.weights[clouds_.source.samples[s]]);
  const auto [source, target] = coarse_.explained (
      movePoints (samples_, poses_, threads_), tightRules(), weights, threads_);
  return source + target - missed();
}

/** Share of the known pairs that lie elsewhere. */
double
PointSolve::missed() const
{
  const MovedPoints moved = movePoints (known_, poses_, threads_);
  double all = 0.0;
  double elsewhere = 0.0;
  for (std::size_t i = 0; i < moved.points.size(); ++i) {
    const KnownPoint& known = prior_.points[i];
    all += known.weight;
    if ((moved.points[i].cast<double>() - known.target).norm() >
        tuning_.limbs.elsewhere)
      elsewhere += known.weight;
  }
  return all > 0.0 ? elsewhere / all : 0.0;
}

void
PointSolve::descend (int first, int last)
{
  const int finest = static_cast<int> (tuning_.stages.size()) - 1;
  for (int c = first; c <= last && !progress_.stopped(); ++c) {
    enter (c);
    match (tuning_.stages[c], c == finest ? fine_ : coarse_);
    if (c == tuning_.limbs.cut)
      most_explained_ = explained();
  }
}

/** Begins where known pairs pull to: from the start, and from there by their common
 * motion, which is right for a body that turned as a whole and wrong for one that moved
 * a limb. What explains more is kept. */
void
PointSolve::chooseStart()
{
  const std::vector<RigidPose> start = poses_;
  std::vector<RigidPose> common = poses_;
  const RigidPose motion = commonMotion (
      prior_.points, movePoints (known_, poses_, threads_).points, tuning_.limbs);
  for (int k = 0; k < segments().size(); ++k)
    if (!segments().isFixed (k))
      common[k] = motion * start[k];
  const auto descendFrom = [this] (const std::vector<RigidPose>& poses) {
    poses_ = poses;
    cut_ = 0;
    enter (0);
    followPairs ({});
    descend (0, tuning_.limbs.cut);
    return most_explained_;
  };
  const double reached = descendFrom (start);
  if (progress_.stopped())
    return;
  const std::vector<RigidPose> kept = poses_;
  if (descendFrom (common) > reached)
    return;
  most_explained_ = reached;
  poses_ = kept;
  cut_ = tuning_.limbs.cut;
  enter (cut_);
}

void
PointSolve::run()
{
  const int last = static_cast<int> (tuning_.stages.size()) - 1;
  const RigidPose start = poses_[0];
  if (known_.size() > 0)
    chooseStart();
  descend (known_.size() > 0 ? tuning_.limbs.cut + 1 : 0, last);
  seekLimbs();
  if (cut_ != last) // stopped
    enter (last);
  if (free_)
    preferWhole (start);
}

} // namespace pcl_msf
