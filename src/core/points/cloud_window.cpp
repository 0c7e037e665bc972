// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/cloud_window.h"

#include "core/base/parallel_for.h"
#include "core/points/cloud_textures.h"
#include "core/points/point_result.h"
#include "core/points/point_window.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <utility>

namespace pcl_msf {

namespace {

constexpr int kSteps = 150; // about, of a target, for the share that is done

/** Place of the target before another one on the way from the source, -1 = none. */
int
beforeOf (int target, int reference)
{
  if (target == reference || target == reference - 1)
    return -1;
  return target > reference ? target - 1 : target + 1;
}

Tuning
tuningFor (double brightness_weight)
{
  if (!(brightness_weight >= 0.0 && brightness_weight <= 1000.0))
    throw InvalidInput ("the weight of brightness is not in [0, 1000]");
  Tuning tuning = currentTuning();
  tuning.points.brightness.weight *= brightness_weight;
  tuning.points.brightness.part_weight *= brightness_weight;
  return tuning;
}

/** Do start and guesses lead to a target? To those after the source, or to those before
 * it when there are none after it. */
bool
isLedTo (int target, const GivenClouds& given)
{
  return target >= given.reference ||
         given.reference == static_cast<int> (given.targets.size());
}

} // namespace

CloudWindow::CloudWindow (const GivenClouds& given,
                          const SolverParameters& solver,
                          const CloudConstraints& constraints)
: given_ (given)
, solver_ (solver)
, begin_ (std::chrono::steady_clock::now())
, tuning_ (tuningFor (given.brightness_weight))
, threads_ (threadCount (solver.threads))
, progress_ (solver, kSteps * static_cast<int> (given.targets.size()))
, segments_ (numberSegments (given.segments, given.source.points))
, frames_ (given.targets.size())
{
  const int targets = static_cast<int> (frames_.size());
  for (const KnownPair& pair : constraints.pairs)
    if (pair.cloud >= targets)
      throw InvalidInput ("a known pair is of target " + std::to_string (pair.cloud) +
                          ", counted from 0, of " + std::to_string (targets) +
                          ": give one of them");
  for (int t = 0; t < targets; ++t) {
    const GivenTarget& target = given.targets[t];
    PointFrame& frame = frames_[t];
    frame.before = beforeOf (t, given.reference);
    frame.clouds = prepare (t);
    addTextures (*target.brightness,
                 given.source.points.size(),
                 target.points.points.size(),
                 tuning_.points.brightness,
                 threads_,
                 frame.clouds);
    frame.prior = priorKnowledge (constraintsOf (t, constraints),
                                  frame.clouds,
                                  segments_,
                                  given.source.points,
                                  target.points.points,
                                  tuning_.points.match);
  }
  segment_seconds_ = seconds();
}

PointClouds
CloudWindow::prepare (int target) const
{
  const GivenTarget& given = given_.targets[target];
  if (target > 0)
    return withTarget (frames_[0].clouds, given.points, given.name, tuning_, threads_);
  return preparePointClouds (
      given_.source, given.points, tuning_, threads_, segments_.of, given.name);
}

/** Pairs are of one target, guesses of those that they lead to. */
CloudConstraints
CloudWindow::constraintsOf (int target, const CloudConstraints& all) const
{
  CloudConstraints own = all;
  own.pairs.erase (std::remove_if (own.pairs.begin(),
                                   own.pairs.end(),
                                   [target] (const KnownPair& pair) {
                                     return pair.cloud != target;
                                   }),
                   own.pairs.end());
  if (!isLedTo (target, given_))
    own.guesses.clear();
  return own;
}

std::unique_ptr<PointSolve>
CloudWindow::solveFrom (const PointFrame& frame, const RigidPose& start, bool chained)
{
  auto solve = std::make_unique<PointSolve> (
      frame.clouds, frame.prior, start, tuning_, threads_, progress_);
  if (chained)
    solve->beginAt (frames_[frame.before].solve->poses());
  solve->run();
  return solve;
}

/** From where the target before was found; from the source, too, when that has not led
 * to all of it, and what explains more is kept. */
void
CloudWindow::chooseStart (PointFrame& frame, const RigidPose& start)
{
  const bool chained = frame.before >= 0;
  frame.solve = solveFrom (frame, start, chained);
  if (!chained || progress_.stopped() || frame.solve->found())
    return;
  std::unique_ptr<PointSolve> direct = solveFrom (frame, start, false);
  if (direct->explained() > frame.solve->explained())
    frame.solve = std::move (direct);
}

void
CloudWindow::solve (PointFrame& frame, const RigidPose& start)
{
  chooseStart (frame, start);
  if (frame.solve->brightnessAgrees() || progress_.stopped())
    return;
  dropTextures (frame.clouds);
  chooseStart (frame, start);
}

std::vector<CloudFlow>
CloudWindow::run (const RigidPose& start, double concatenation_weight)
{
  const int targets = static_cast<int> (frames_.size());
  const RigidPose scaled = frames_[0].clouds.scaled (start);
  for (int t = given_.reference; t < targets; ++t)
    solve (frames_[t], scaled);
  for (int t = given_.reference - 1; t >= 0; --t)
    solve (frames_[t], isLedTo (t, given_) ? scaled : RigidPose());
  solveJointly (frames_, concatenation_weight, tuning_.points, threads_, progress_);
  const double solve_seconds = seconds() - segment_seconds_;
  std::vector<CloudFlow> flows = makeCloudFlows (frames_,
                                                 segments_,
                                                 given_.source.points,
                                                 solver_.merge_bodies,
                                                 tuning_.points,
                                                 threads_);
  for (int t = 0; t < targets; ++t) {
    CloudFlow& flow = flows[t];
    noteOutcome (progress_, frames_[t].solve->scattered(), tuning_.points.result, flow);
    if (targets > 1 && !flow.report.message.empty())
      flow.report.message = given_.targets[t].name + ": " + flow.report.message;
    flow.report.segment_seconds = segment_seconds_;
    flow.report.solve_seconds = solve_seconds;
    flow.report.result_seconds = seconds() - segment_seconds_ - solve_seconds;
  }
  progress_.finish();
  return flows;
}

double
CloudWindow::seconds() const
{
  const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin_;
  return gone.count();
}

} // namespace pcl_msf
