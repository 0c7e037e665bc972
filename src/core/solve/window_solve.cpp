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

MultiframeSceneFlow
WindowSolve::run (const RigidPose& guess, const std::vector<KnownStep>& known)
{
  follows_ = followed_ && startFollowing();
  if (!follows_)
    start (guess, known);
  solve (follows_ ? followSchedule() : isPair() ? pairSchedule (0) : windowSchedule());
  return finish();
}

void
WindowSolve::solve (const RigidPose& guess, int finest_level)
{
  start (guess, {});
  solve (pairSchedule (finest_level));
}

bool
WindowSolve::solveFollowed()
{
  follows_ = startFollowing();
  if (follows_)
    solve (followSchedule());
  return follows_;
}

void
WindowSolve::solve (const std::vector<Round>& schedule)
{
  report_.start_seconds = monitor_.seconds();
  begin_ = 0.0;
  share_ = 1.0;
  for (auto r = schedule.begin(); r != schedule.end(); ++r) {
    if (r->anew)
      enterLevel (*r);
    if (r == schedule.begin())
      prepareUpcoming ({r + 1, schedule.end()});
    round (*r);
  }
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
    scene_.brightness_area = brightness_area_ = 1.0;
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
  scene_.change.local = start.lightChanged();
  scene_.brightness_area = scene_.noise.areas.brightness;
  scene_.centroids = start.centroids();
  state_ = start.state();
}

void
WindowSolve::round (const Round& round)
{
  std::vector<char> jumped; // empty: all move
  if (round.spread && (jumped = spreadMotions()).empty()) {
    if (round.measure)
      measureCorrelation (round.level);
    return;
  }
  if (round.propose && state_.bodies() == scene_.segments)
    pair_start_.proposeAgain (*level_, state_.poses[0]);
  if (round.presort && user_.merge_bodies) {
    level_->sweep (state_, DataTerm::Pass::Linearize);
    merge();
    const double brightness = scene_.noise.areas.brightness;
    measureCorrelation (round.level);
    if (!isPair()) { // the start knows brightness better: it erred over its frames
      scene_.noise.areas.brightness = brightness;
      level_->reweigh();
    }
    if (isPair() && round.anew) // later, bodies err by what they join, too
      brightness_area_ = scene_.noise.areas.brightness;
  }
  if (round.rescale_noise)
    level_->rescaleBodyNoise (state_);
  monitor_.enter (round.stage, round.level, round.begin, round.end, round.iterations);
  if (round.together)
    state_.joinEqualPoses (scene_.links, jumped);
  minimize (round.iterations, movingBodies (jumped));
  if (round.together)
    state_.separate();
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

/** \param moving per body: may it move? empty: all */
void
WindowSolve::minimize (int iterations, const std::vector<char>& moving)
{
  Energy energy (*level_, scene_, energy_, multiframe_.concatenation_weight, state_);
  energy.letMove (moving);
  SolverParameters solver = solver_;
  if (!isPair())
    solver.function_tolerance *= scene_.tuning.solve.tolerance_share;
  solver.max_iterations = cancelled_ ? 0 : iterations;
  const SolveOutcome outcome = pcl_msf::minimize (energy, solver, monitor_, state_);
  report_.initial_cost = outcome.initial;
  report_.final_cost = outcome.final;
  report_.stop_reason =
      endOfSolve (outcome.settled (scene_.tuning.solve.settled), outcome.failed);
}

/** Lost segments try their neighbours' motions. \return per segment: did it jump? Empty
 * where few did */
std::vector<char>
WindowSolve::spreadMotions()
{
  const std::vector<RigidPose> before = state_.poses[0];
  const int jumps = pair_start_.proposeToLost (*level_, state_.poses[0]);
  if (jumps == 0 || jumps < scene_.tuning.solve.enough_jumps * scene_.segments)
    return {};
  std::vector<char> jumped (scene_.segments, 0);
  for (int k = 0; k < scene_.segments; ++k)
    jumped[k] = before[k].parameters != state_.poses[0][k].parameters;
  return jumped;
}

/** Per body: did a segment of it jump, or one that it is linked with? Empty: all move.
 */
std::vector<char>
WindowSolve::movingBodies (const std::vector<char>& jumped) const
{
  if (jumped.empty())
    return {};
  std::vector<char> moving (state_.bodies(), 0);
  for (const SegmentLink& link : scene_.links)
    if (jumped[link.first] != 0 || jumped[link.second] != 0)
      moving[state_.body_of[link.first]] = moving[state_.body_of[link.second]] = 1;
  return moving;
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
  AssignmentRules rules;
  rules.window = !isPair();
  rules.background = multiframe_.static_background;
  rules.hides = isPair() && !follows_;
  reassignBodies (level_->terms(),
                  scene_.links,
                  scene_.tuning.bodies.assignment,
                  rules,
                  scene_.threads,
                  state_);
}

} // namespace pcl_msf
