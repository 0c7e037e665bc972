// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/two_frame_solve.h"

#include "core/body_assignment.h"
#include "core/body_merging.h"
#include "core/dense_points.h"
#include "core/dense_result.h"
#include "core/dense_visibility.h"
#include "core/hidden_segments.h"
#include "core/outcome.h"
#include "core/parallel_for.h"

#include <algorithm>

namespace pcl_msf {

namespace {

constexpr int kCoarsestLevel = 2; // the first joint solve
constexpr double kLeastIntensityNoise = 0.005;
constexpr double kModelError = 0.15; // pixels that rigid segments leave unexplained
constexpr double kRelativeDepthNoise = 0.003; // of inverse depth, beside the noise
constexpr int kLaterRounds = 2;
constexpr int kLastIterations = 4; // after the last merge

} // namespace

TwoFrameSolve::TwoFrameSolve (const RgbdFrame& reference,
                              const RgbdFrame& current,
                              const Oversegmentation& segments,
                              const EnergyParameters& energy,
                              const SolverParameters& solver)
: frames_{reference, current}
, segments_ (segments)
, energy_ (energy)
, solver_ (solver)
, levels_ (std::min<int> ({solver.levels,
                           static_cast<int> (reference.levels().size()),
                           static_cast<int> (current.levels().size())}))
, monitor_ (solver_)
, scene_{frames_, pairs_, segments.size(), threadCount (solver.threads), {0}}
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
  const RgbdFrame& reference = frames_[0];
  const RgbdFrame& current = frames_[1];
  scene_.noise.inverse_depth =
      std::max (reference.inverseDepthNoise(), current.inverseDepthNoise());
  scene_.noise.intensity = std::max (
      {reference.intensityNoise(), current.intensityNoise(), kLeastIntensityNoise});
  scene_.noise.displacement = kModelError;
  scene_.noise.relative_depth = kRelativeDepthNoise;
}

/** Minimizes Eq. 5 on the present level. */
void
TwoFrameSolve::minimize (int iterations)
{
  Energy energy (*level_, scene_, energy_, 0.0, state_);
  SolverParameters solver = solver_;
  solver.max_iterations = iterations;
  const SolveOutcome outcome = pcl_msf::minimize (energy, solver, monitor_, state_);
  report_.initial_cost = outcome.initial;
  report_.final_cost = outcome.final;
  report_.stop_reason = endOfSolve (outcome.settled(), outcome.failed);
}

/** Solves a level; at the two finest, segments that move as one merge. */
void
TwoFrameSolve::refine (int at)
{
  level_ = std::make_unique<WindowLevel> (
      scene_, at, std::vector<cv::Mat>{labels_[at], {}}, energy_);
  if (at < kCoarsestLevel && state_.bodies() == scene_.segments)
    propose (level_->probes (0), level_->focalLength(), {}, kLaterRounds);
  // The finest level is about half of the work, the start a fifth.
  const double begin = at == 0 ? 0.5 : 0.5 - 0.15 * at;
  monitor_.enter (
      "solve", at, begin, begin + (at == 0 ? 0.3 : 0.15), solver_.max_iterations);
  minimize (solver_.max_iterations);
  if (solver_.merge_bodies && at < kCoarsestLevel) {
    merge();
    reassignBodies (level_->terms(), scene_.links, {}, scene_.threads, state_);
  }
  if (at == 0)
    finishBodies();
}

/** The last steps at the finest level. */
void
TwoFrameSolve::finishBodies()
{
  if (solver_.merge_bodies) {
    level_->sharpenRigidBodies (state_);
    const int iterations = std::min (solver_.max_iterations, kLastIterations);
    monitor_.enter ("bodies", 0, 0.8, 1.0, iterations);
    minimize (iterations);
  }
  if (followNeighbors (level_->terms(), scene_.links, state_) > 0)
    level_->sweep (state_, DataTerm::Pass::Linearize);
  if (solver_.merge_bodies)
    merge();
  Energy (*level_, scene_, energy_, 0.0, state_).relaxWeights (state_);
}

void
TwoFrameSolve::merge()
{
  mergeBodies (level_->terms(), pairs_.frames(), scene_.links, {}, state_);
}

void
TwoFrameSolve::finish (SceneFlow& result)
{
  const double before = monitor_.seconds();
  level_->sweep (state_, DataTerm::Pass::Linearize);
  const DataTerm& data = level_->data (0);
  result.camera = frames_[0].camera();
  result.labels = segments_.labels();
  fillSegments (data,
                scene_.links,
                state_.ofPair (0),
                residualScale (energy_, data.pixels()),
                scene_.threads,
                result);
  fillPoints (data, frames_[1].camera(), solver_.blend_motions, scene_.threads, result);
  fillVisibility (data, scene_.threads, result);
  concludeReport (result);
  result.report.result_seconds = monitor_.seconds() - before;
}

void
TwoFrameSolve::concludeReport (SceneFlow& result)
{
  report_.iterations = monitor_.iterations();
  report_.history = monitor_.history();
  conclude (monitor_.stopReason(),
            {judgeMotion (frames_[0], frames_[1], scene_.noise.intensity, result)},
            report_);
  result.report = report_;
}

} // namespace pcl_msf
