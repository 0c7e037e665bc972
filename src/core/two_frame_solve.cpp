// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/two_frame_solve.h"

#include "core/body_assignment.h"
#include "core/body_noise.h"
#include "core/dense_points.h"
#include "core/dense_result.h"
#include "core/dense_visibility.h"
#include "core/hidden_segments.h"
#include "core/outcome.h"
#include <omp.h>

#include <algorithm>

namespace pcl_msf {

namespace {

constexpr int kCoarsestLevel = 2;           // the first joint solve
constexpr double kRelativeTolerance = 0.01; // of the z-test; doubles per level
constexpr double kLeastIntensityNoise = 0.005;
constexpr double kModelError = 0.15; // pixels that rigid segments leave unexplained
constexpr double kRelativeDepthNoise = 0.003; // of inverse depth, beside the noise
constexpr int kLaterRounds = 2;
constexpr int kLastIterations = 4; // after the last merge

int
threadCount (unsigned wanted)
{
  return wanted > 0 ? static_cast<int> (wanted) : omp_get_max_threads();
}

} // namespace

TwoFrameSolve::TwoFrameSolve (const RgbdFrame& reference,
                              const RgbdFrame& current,
                              const Oversegmentation& segments,
                              const EnergyParameters& energy,
                              const SolverParameters& solver)
: reference_ (reference)
, current_ (current)
, segments_ (segments)
, energy_ (energy)
, solver_ (solver)
, threads_ (threadCount (solver.threads))
, levels_ (std::min<int> ({solver.levels,
                           static_cast<int> (reference.levels().size()),
                           static_cast<int> (current.levels().size())}))
, monitor_ (solver_)
{}

SceneFlow
TwoFrameSolve::run (const RigidPose& guess)
{
  solve (guess, 0);
  SceneFlow result;
  finish (result);
  return result;
}

void
TwoFrameSolve::solve (const RigidPose& guess, int finest_level)
{
  prepare();
  start (guess);
  report_.start_seconds = monitor_.seconds();
  const int finest = std::min (finest_level, levels_ - 1);
  for (int level = std::min (kCoarsestLevel, levels_ - 1); level >= finest; --level)
    refine (level);
  report_.solve_seconds = monitor_.seconds() - report_.start_seconds;
}

/** Labels of all levels and the noise that residuals are measured in. */
void
TwoFrameSolve::prepare()
{
  labels_.push_back (segments_.labels());
  for (int level = 1; level < levels_; ++level)
    labels_.push_back (halveLabels (labels_.back()));
  noise_.inverse_depth =
      std::max (reference_.inverseDepthNoise(), current_.inverseDepthNoise());
  noise_.intensity = std::max (
      {reference_.intensityNoise(), current_.intensityNoise(), kLeastIntensityNoise});
  noise_.displacement = kModelError;
  noise_.relative_depth = kRelativeDepthNoise;
}

LevelData
TwoFrameSolve::levelData (int level, bool with_pixels) const
{
  return LevelData (reference_.levels()[level],
                    current_.levels()[level],
                    labels_[level],
                    segments_.size(),
                    noise_,
                    kRelativeTolerance * (1 << level),
                    change_,
                    with_pixels,
                    threads_);
}

/** Minimizes Eq. 5 on a level; at the two finest, segments that move as one merge. */
void
TwoFrameSolve::refine (int at)
{
  LevelData level = levelData (at, true);
  DataTerm data (
      level.pixels, level.texture, makeRules (energy_, level.pixels), threads_);
  JointEnergy energy (data, links_, energy_, level.focal_length);
  if (at < kCoarsestLevel && state_.poses.size() == state_.body_of.size())
    propose (level, FlowHypotheses{}, kLaterRounds);
  // The finest level is about half of the work, the start a fifth.
  const double begin = at == 0 ? 0.5 : 0.5 - 0.15 * at;
  monitor_.enter (
      "solve", at, begin, begin + (at == 0 ? 0.3 : 0.15), solver_.max_iterations);
  SolveOutcome outcome = energy.minimize (solver_, monitor_, state_);
  if (solver_.merge_bodies && at < kCoarsestLevel) {
    mergeAndReassign (energy, level);
    if (at == 0) {
      sharpenRigidBodies (data, state_, threads_, level.pixels);
      SolverParameters last = solver_;
      last.max_iterations = std::min (solver_.max_iterations, kLastIterations);
      monitor_.enter ("bodies", at, 0.8, 1.0, last.max_iterations);
      outcome = energy.minimize (last, monitor_, state_);
    }
  }
  if (at == 0) {
    if (followNeighbors (data, links_, state_) > 0)
      data.sweep (state_, DataTerm::Pass::Linearize);
    if (solver_.merge_bodies)
      merge (level, data);
    energy.relaxWeights (state_);
    finest_ = std::make_unique<LevelData> (std::move (level));
  }
  report_.initial_cost = outcome.initial;
  report_.final_cost = outcome.final;
  report_.stop_reason = endOfSolve (outcome.settled(), outcome.failed);
}

void
TwoFrameSolve::merge (const LevelData& level, const DataTerm& data)
{
  state_ =
      mergeBodies (data, residualScale (energy_, level.pixels), links_, {}, state_);
}

void
TwoFrameSolve::mergeAndReassign (JointEnergy& energy, LevelData& level)
{
  merge (level, energy.data());
  const DataTerm sample (
      level.probes, level.texture, makeRules (energy_, level.probes), threads_);
  reassignBodies (energy.data(), sample, links_, {}, threads_, state_);
}

void
TwoFrameSolve::finish (SceneFlow& result)
{
  const double before = monitor_.seconds();
  const SegmentPixels& pixels = finest_->pixels;
  DataTerm data (pixels, finest_->texture, makeRules (energy_, pixels), threads_);
  data.sweep (state_, DataTerm::Pass::Linearize);
  result.camera = reference_.camera();
  result.labels = segments_.labels();
  fillSegments (
      data, links_, state_, residualScale (energy_, pixels), threads_, result);
  fillPoints (data, current_.camera(), solver_.blend_motions, threads_, result);
  fillVisibility (data, threads_, result);
  concludeReport (result);
  result.report.result_seconds = monitor_.seconds() - before;
}

void
TwoFrameSolve::concludeReport (SceneFlow& result)
{
  report_.iterations = monitor_.iterations();
  report_.history = monitor_.history();
  conclude (monitor_.stopReason(),
            {judgeMotion (reference_, current_, noise_.intensity, result)},
            report_);
  result.report = report_;
}

} // namespace pcl_msf
