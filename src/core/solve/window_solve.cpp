// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/solve/window_solve.h"

#include "core/base/parallel_for.h"
#include "core/bodies/body_assignment.h"
#include "core/bodies/body_merging.h"
#include "core/bodies/hidden_segments.h"
#include "core/data/correlation_area.h"
#include "core/result/outcome.h"

#include <algorithm>
#include <cstdlib>

namespace pcl_msf {

namespace {

constexpr double kCertain = 1e9; // prior of AssignmentTuning, with a known background
constexpr double kStartShare = 0.5; // of the work

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

int
fewestLevels (const std::vector<RgbdFrame>& frames, int wanted)
{
  std::size_t levels = wanted;
  for (const RgbdFrame& frame : frames)
    levels = std::min (levels, frame.levels().size());
  return static_cast<int> (levels);
}

} // namespace

WindowSolve::WindowSolve (const std::vector<RgbdFrame>& frames,
                          int reference,
                          const Oversegmentation& segments,
                          const EnergyParameters& energy,
                          const SolverParameters& solver,
                          const MultiframeParameters& multiframe,
                          const Tuning& tuning)
: frames_ (frames)
, pairs_ (static_cast<int> (frames.size()), reference)
, segments_ (segments)
, energy_ (energy)
, user_ (solver)
, multiframe_ (multiframe)
, solver_ (watchedSolver())
, levels_ (fewestLevels (frames, solver.levels))
, monitor_ (solver_)
, scene_{frames_,
         pairs_,
         segments.size(),
         threadCount (solver.threads),
         tuning,
         usedPairs (pairs_, multiframe.max_span)}
, pair_start_ (scene_, energy_, solver_)
{}

/** The user's parameters, with progress of a stage scaled to that of the window. Once
 * the user cancels, nothing goes on. */
SolverParameters
WindowSolve::watchedSolver()
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

/** From coarse to fine; at the two finest levels, segments that move as one merge. The
 * finest level is about half of the work, the start a fifth. */
std::vector<WindowSolve::Round>
WindowSolve::pairSchedule (int finest_level) const
{
  std::vector<Round> rounds;
  const SolveTuning& tuning = scene_.tuning.solve;
  const int finest = std::min (finest_level, levels_ - 1);
  const int coarsest = std::min (tuning.coarsest_level, levels_ - 1);
  const int few = std::min (user_.max_iterations, tuning.later_iterations);
  for (int level = coarsest; level >= finest; --level) {
    const double begin = level == 0 ? 0.5 : 0.5 - 0.15 * level;
    Round round{"solve",
                level,
                begin,
                begin + (level == 0 ? 0.3 : 0.15),
                level == coarsest ? user_.max_iterations : few};
    round.propose = round.merge = level < tuning.coarsest_level;
    if (level == 0 && coarsest > 0)
      round.iterations = std::min (few, tuning.finest_iterations);
    rounds.push_back (round);
    if (level == tuning.coarsest_level)
      addSpreads (rounds);
    else if (level > 0 && user_.merge_bodies)
      addBodies (rounds);
  }
  if (finest > 0)
    return rounds;
  if (user_.merge_bodies) {
    rounds.push_back ({"bodies", 0, 0.8, 1.0, few});
    rounds.back().anew = false;
    rounds.back().rescale_noise = true;
  }
  rounds.back().last = true;
  return rounds;
}

/** Above the finest level bodies are found twice, which is cheap there: those that move
 * as one body fit their place better than the segments did, so more of them find
 * theirs. */
void
WindowSolve::addBodies (std::vector<Round>& rounds) const
{
  Round again = rounds.back();
  rounds.back().end = again.begin = 0.5 * (again.begin + again.end);
  again.stage = "bodies";
  again.anew = again.propose = false;
  again.rescale_noise = true;
  rounds.push_back (again);
}

/** At the coarsest level, segments that lie beyond the start's reach get their motions
 * from neighbours, step by step: as the end of a sheet that bends. */
void
WindowSolve::addSpreads (std::vector<Round>& rounds) const
{
  const int spreads = scene_.tuning.solve.spreads;
  const double share = (rounds.back().end - rounds.back().begin) / (1 + spreads);
  rounds.back().end = rounds.back().begin + share;
  for (int i = 0; i < spreads; ++i) {
    Round again = rounds.back();
    again.begin += share;
    again.end += share;
    again.anew = false;
    again.spread = true;
    again.measure = i + 1 == spreads;
    rounds.push_back (again);
  }
}

/** The start leaves apart what may be one over all pairs, as textureless pieces of one
 * surface, which the solve would let drift: bodies merge first. */
std::vector<WindowSolve::Round>
WindowSolve::windowSchedule() const
{
  const int few = std::min (user_.max_iterations, scene_.tuning.solve.later_iterations);
  const double third = (1.0 - kStartShare) / 3.0;
  std::vector<Round> rounds;
  for (int i = 0; i < 3; ++i) {
    Round round{"window",
                std::min (i == 0 ? 1 : 0, levels_ - 1),
                kStartShare + i * third,
                kStartShare + (i + 1) * third,
                i == 0 ? user_.max_iterations : few};
    round.presort = i == 0;
    round.rescale_noise = i > 0;
    round.merge = i < 2;
    round.fuse = i == 2;
    rounds.push_back (round);
  }
  return rounds;
}

MultiframeSceneFlow
WindowSolve::run (const RigidPose& guess, const std::vector<KnownStep>& known)
{
  const bool follows = followed_ && startFollowing();
  if (!follows)
    start (guess, known);
  solve (follows ? followSchedule() : isPair() ? pairSchedule (0) : windowSchedule());
  return finish();
}

void
WindowSolve::solve (const RigidPose& guess, int finest_level)
{
  start (guess, {});
  solve (pairSchedule (finest_level));
}

void
WindowSolve::solve (const std::vector<Round>& schedule)
{
  report_.start_seconds = monitor_.seconds();
  begin_ = 0.0;
  share_ = 1.0;
  for (const Round& r : schedule)
    round (r);
  report_.solve_seconds = monitor_.seconds() - report_.start_seconds;
}

/** What residuals of two frames are measured in. */
void
WindowSolve::measureNoise()
{
  const NoiseTuning& tuning = scene_.tuning.solve.noise;
  scene_.noise = {tuning.least_intensity,
                  tuning.model_error,
                  0.0,
                  tuning.relative_depth,
                  {tuning.brightness_area, tuning.icp_area}};
  for (const RgbdFrame& frame : frames_) {
    scene_.noise.intensity = std::max (scene_.noise.intensity, frame.intensityNoise());
    scene_.noise.inverse_depth =
        std::max (scene_.noise.inverse_depth, frame.inverseDepthNoise());
  }
}

void
WindowSolve::start (const RigidPose& guess, const std::vector<KnownStep>& known)
{
  if (isPair()) {
    measureNoise();
    scene_.change = {};
    scene_.fused_depth = cv::Mat();
    const int at = std::min (scene_.tuning.solve.start_level, levels_ - 1);
    std::vector<RigidPose> poses =
        pair_start_.run (carryLabels (at)[pairs_.reference()], at, guess, given_start_);
    state_ = WindowState (
        MotionState::fromSegments (std::move (poses), scene_.links.size()));
    return;
  }
  share_ = kStartShare;
  WindowStart start (frames_, pairs_, segments_, energy_, solver_, scene_.tuning);
  start.run (guess, known);
  scene_.links = start.links();
  scene_.noise = start.noise();
  scene_.exposure = start.exposure();
  scene_.centroids = start.centroids();
  state_ = start.state();
}

/** A round's level, with segments carried by the present poses. */
void
WindowSolve::enterLevel (const Round& round)
{
  const std::vector<cv::Mat> labels = carryLabels (round.level);
  if (!isPair())
    fitExposures (round.level, labels[pairs_.reference()]);
  if (round.fuse)
    fuseDepth();
  level_ = std::make_unique<WindowLevel> (scene_, round.level, labels, energy_);
}

void
WindowSolve::round (const Round& round)
{
  if (round.anew)
    enterLevel (round);
  if (round.spread && !spreadMotions()) {
    if (round.measure)
      measureCorrelation (round.level);
    return;
  }
  if (round.propose && state_.bodies() == scene_.segments)
    pair_start_.proposeAgain (*level_, state_.poses[0]);
  if (round.presort && user_.merge_bodies) {
    level_->sweep (state_, DataTerm::Pass::Linearize);
    merge();
  }
  if (round.rescale_noise)
    level_->rescaleBodyNoise (state_);
  monitor_.enter (round.stage, round.level, round.begin, round.end, round.iterations);
  minimize (round.iterations);
  if (round.measure)
    measureCorrelation (round.level);
  if (round.merge && user_.merge_bodies) {
    merge();
    reassign();
    if (!round.keep_worth)
      measureCorrelation (round.level);
  }
  if (isPair() &&
      round.level == std::min (scene_.tuning.solve.start_level, levels_ - 1))
    fit_ = costsPerResidual();
  if (!round.last)
    return;
  if (assignHiddenSegments (
          level_->terms(), scene_.links, scene_.tuning.bodies.hidden, state_) > 0)
    level_->sweep (state_, DataTerm::Pass::Linearize);
  if (user_.merge_bodies)
    merge();
  Energy (*level_, scene_, energy_, multiframe_.concatenation_weight, state_)
      .relaxWeights (state_);
}

void
WindowSolve::minimize (int iterations)
{
  Energy energy (*level_, scene_, energy_, multiframe_.concatenation_weight, state_);
  SolverParameters solver = solver_;
  if (!isPair())
    solver.function_tolerance *= scene_.tuning.solve.tolerance_share;
  solver.max_iterations = cancelled_ ? 0 : iterations;
  const SolveOutcome outcome = pcl_msf::minimize (energy, solver, monitor_, state_);
  report_.initial_cost = outcome.initial;
  report_.final_cost = outcome.final;
  report_.stop_reason = endOfSolve (outcome.settled(), outcome.failed);
}

/** Lost segments try their neighbours' motions. \return did enough of them jump? */
bool
WindowSolve::spreadMotions()
{
  const int jumps = pair_start_.proposeToLost (*level_, state_.poses[0]);
  return jumps >= scene_.tuning.solve.enough_jumps * scene_.segments;
}

/** What the residuals are worth, from those of the present bodies. */
void
WindowSolve::measureCorrelation (int level)
{
  scene_.noise.areas = measureCorrelationAreas (level_->terms(),
                                                state_,
                                                level,
                                                scene_.noise.areas,
                                                scene_.tuning.data.correlation,
                                                scene_.threads);
  level_->reweigh();
}

void
WindowSolve::merge()
{
  mergeBodies (level_->terms(),
               pairs_.frames(),
               scene_.links,
               scene_.tuning.bodies.merging,
               state_);
}

void
WindowSolve::reassign()
{
  AssignmentTuning rules = scene_.tuning.bodies.assignment;
  if (!isPair())
    rules.separation = rules.window_separation;
  if (multiframe_.static_background)
    rules.prior = kCertain;
  reassignBodies (level_->terms(), scene_.links, rules, scene_.threads, state_);
}

} // namespace pcl_msf
