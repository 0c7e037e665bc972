// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/multi_frame_solve.h"

#include "core/body_assignment.h"
#include "core/body_merging.h"
#include "core/depth_fusion.h"
#include "core/exposure.h"
#include "core/outcome.h"
#include "core/segment_carrier.h"
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace pcl_msf {

namespace {

constexpr double kRelativeTolerance =
    0.01;                            // of the z-test at level 0; doubles per level
constexpr double kSeparation = 0.2;  // mean cost that leaving all neighbours costs
constexpr double kBackground = 0.3;  // mean cost that leaving a known background costs
constexpr int kExposureSamples = 64; // per segment
constexpr int kLaterIterations = 4;  // of a round at the finest level
constexpr double kToleranceShare = 0.1; // a pair alone changes a sum of pairs little
constexpr double kStartShare = 0.5;     // of the work

/** Pairs that take part: all, or those with the reference and those of frames near each
 * other. */
std::vector<int>
usedPairs (const FramePairs& pairs, int max_span)
{
  std::vector<int> used;
  for (int p = 0; p < pairs.count(); ++p) {
    const int span = std::abs (pairs[p].to - pairs[p].from);
    if (max_span == 0 || span <= max_span || pairs[p].from == pairs.reference())
      used.push_back (p);
  }
  return used;
}

} // namespace

MultiFrameSolve::MultiFrameSolve (const std::vector<RgbdFrame>& frames,
                                  int reference,
                                  const Oversegmentation& segments,
                                  const EnergyParameters& energy,
                                  const SolverParameters& solver,
                                  const MultiframeParameters& multiframe)
: frames_ (frames)
, pairs_ (static_cast<int> (frames.size()), reference)
, segments_ (segments)
, energy_ (energy)
, user_ (solver)
, multiframe_ (multiframe)
, solver_ (watchedSolver())
, monitor_ (solver_)
, scene_{frames_,
         pairs_,
         usedPairs (pairs_, multiframe.max_span),
         {},
         {},
         {},
         {},
         0.0,
         {},
         segments.size(),
         solver.threads > 0 ? static_cast<int> (solver.threads) : omp_get_max_threads()}
{}

/** The user's parameters, with progress of a stage scaled to that of the window. Once
 * the user cancels, nothing goes on. */
SolverParameters
MultiFrameSolve::watchedSolver()
{
  SolverParameters watched = user_;
  watched.progress = [this] (const Progress& progress) {
    if (cancelled_ || !user_.progress)
      return !cancelled_;
    Progress scaled = progress;
    scaled.fraction = begin_ + share_ * progress.fraction;
    cancelled_ = !user_.progress (scaled);
    return !cancelled_;
  };
  return watched;
}

MultiframeSceneFlow
MultiFrameSolve::run (const RigidPose& guess, const std::vector<KnownStep>& known)
{
  start (guess, known);
  report_.start_seconds = monitor_.seconds();
  const int most = user_.max_iterations;
  const int few = std::min (most, kLaterIterations);
  const std::vector<Round> rounds = {
      {1, most, Round::First}, {0, few, Round::Middle}, {0, few, Round::Last}};
  begin_ = 0.0;
  share_ = 1.0;
  double begin = kStartShare;
  for (const Round& r : rounds) {
    const double end =
        begin + (1.0 - kStartShare) / static_cast<double> (rounds.size());
    round (r, begin, end);
    begin = end;
  }
  report_.solve_seconds = monitor_.seconds() - report_.start_seconds;
  return finish();
}

void
MultiFrameSolve::start (const RigidPose& guess, const std::vector<KnownStep>& known)
{
  share_ = kStartShare;
  MultiFrameStart start (frames_, pairs_, segments_, energy_, solver_);
  start.run (guess, known);
  scene_.links = start.links();
  scene_.noise = start.noise();
  scene_.exposure = start.exposure();
  scene_.centroids = start.centroids();
  state_ = start.state();
}

/** Compares every frame's exposure with the reference's, at the present poses. */
void
MultiFrameSolve::fitExposures (int at, const cv::Mat& labels)
{
  const int reference = pairs_.reference();
  PointOptions options;
  options.noise = scene_.noise;
  options.relative_tolerance = kRelativeTolerance * (1 << at);
  options.max_per_segment = kExposureSamples;
  options.threads = scene_.threads;
  const SegmentPixels points =
      groupPixels (frames_[reference].levels()[at], labels, scene_.segments, options);
  std::vector<MatchedIntensities> matches (frames_.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(scene_.threads)
  for (int f = 0; f < pairs_.frames(); ++f) {
    if (f == reference)
      continue;
    matches[f] = matchIntensities (
        points, state_.ofPair (pairs_.fromReference (f)), frames_[f].levels()[at]);
    scene_.exposure[f] = fitBrightnessChange (matches[f].reference, matches[f].current);
  }
  scene_.falloff = fitFalloff (matches, scene_.exposure);
}

/** All frames' measurements of the reference's points in one. */
void
MultiFrameSolve::fuseDepth()
{
  const int reference = pairs_.reference();
  std::vector<DepthWitness> witnesses;
  for (int f = 0; f < pairs_.frames(); ++f)
    if (f != reference)
      witnesses.push_back (
          {&frames_[f].levels()[0], state_.ofPair (pairs_.fromReference (f))});
  scene_.fused_depth = fuseInverseDepth (frames_[reference].levels()[0],
                                         segments_.labels(),
                                         witnesses,
                                         scene_.noise,
                                         scene_.threads);
}

cv::Mat
MultiFrameSolve::labelsIn (int frame) const
{
  return pcl_msf::carryLabels (frames_[pairs_.reference()].levels()[0],
                               segments_.labels(),
                               state_.ofPair (pairs_.fromReference (frame)),
                               frames_[frame].levels()[0],
                               scene_.noise);
}

std::vector<cv::Mat>
MultiFrameSolve::carryLabels() const
{
  const int reference = pairs_.reference();
  std::vector<cv::Mat> labels (frames_.size());
  labels[reference] = segments_.labels();
  std::vector<int> sources;
  for (const int p : scene_.used)
    if (pairs_[p].from != reference)
      sources.push_back (pairs_[p].from);
  std::sort (sources.begin(), sources.end());
  sources.erase (std::unique (sources.begin(), sources.end()), sources.end());
  const int count = static_cast<int> (sources.size());
#pragma omp parallel for schedule(dynamic, 1) num_threads(scene_.threads)
  for (int i = 0; i < count; ++i) {
    const int f = sources[i];
    labels[f] = labelsIn (f);
  }
  return labels;
}

/** Eq. 13 on a level, with segments carried by the present poses. */
void
MultiFrameSolve::round (const Round& round, double begin, double end)
{
  const int finest = static_cast<int> (frames_[0].levels().size()) - 1;
  const int at = std::min ({round.level, user_.levels - 1, finest});
  std::vector<cv::Mat> labels = carryLabels();
  for (int i = 0; i < at; ++i)
    for (cv::Mat& image : labels)
      if (!image.empty())
        image = halveLabels (image);
  fitExposures (at, labels[pairs_.reference()]);
  if (round.place == Round::Last)
    fuseDepth();
  level_ = std::make_unique<MultiFrameLevel> (
      scene_, at, labels, energy_, kRelativeTolerance * (1 << at));
  if (round.place == Round::First && user_.merge_bodies)
    mergeAtStart (*level_);
  if (round.place != Round::First)
    level_->sharpenRigidBodies (state_);
  MultiFrameEnergy energy (
      *level_, scene_, energy_, multiframe_.concatenation_weight, state_);
  monitor_.enter ("window", at, begin, end, round.iterations);
  SolverParameters solver = solver_;
  solver.function_tolerance *= kToleranceShare;
  solver.max_iterations = cancelled_ ? 0 : round.iterations;
  const SolveOutcome outcome = energy.minimize (solver, monitor_, state_);
  report_.initial_cost = outcome.initial;
  report_.final_cost = outcome.final;
  report_.stop_reason = endOfSolve (outcome.settled(), outcome.failed);
  if (round.place != Round::Last && user_.merge_bodies)
    mergeAndReassign (*level_);
}

/** The used pairs at a level, as the steps that form bodies see them. */
std::vector<PairTerms>
MultiFrameSolve::pairTerms (const MultiFrameLevel& level) const
{
  std::vector<PairTerms> terms;
  for (const int p : scene_.used) {
    const DataTerm& data = level.data (p);
    const bool own = pairs_[p].from == pairs_.reference();
    terms.push_back ({p,
                      &data,
                      own ? &level.probes (p) : nullptr,
                      residualScale (energy_, data.pixels())});
  }
  return terms;
}

/** What the start leaves apart may be one over all pairs: textureless pieces of one
 * surface, which the solve would let drift. */
void
MultiFrameSolve::mergeAtStart (MultiFrameLevel& level)
{
  level.sweep (state_, DataTerm::Pass::Linearize);
  mergeBodies (pairTerms (level), pairs_.frames(), scene_.links, {}, state_);
}

void
MultiFrameSolve::mergeAndReassign (MultiFrameLevel& level)
{
  const std::vector<PairTerms> terms = pairTerms (level);
  mergeBodies (terms, pairs_.frames(), scene_.links, {}, state_);
  AssignmentRules rules;
  rules.separation = kSeparation;
  rules.background = multiframe_.static_background ? kBackground : 0.0;
  reassignBodies (terms, scene_.links, rules, scene_.threads, state_);
}

} // namespace pcl_msf
