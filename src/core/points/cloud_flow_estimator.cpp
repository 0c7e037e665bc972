// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include "core/points/cloud_textures.h"
#include "core/points/point_result.h"
#include "core/points/point_solve.h"
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/errors.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>

namespace pcl_msf {

namespace {

constexpr int kSteps = 150; // about, for the share that is done

double
secondsSince (std::chrono::steady_clock::time_point begin)
{
  const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin;
  return gone.count();
}

} // namespace

CloudFlowEstimator::CloudFlowEstimator (SolverParameters solver,
                                        CloudConstraints constraints)
: solver_ (std::move (solver)), constraints_ (std::move (constraints))
{
  std::string why;
  if (!solver_.isValid (&why) || !constraints_.isValid (&why))
    throw InvalidInput (why);
}

CloudFlow
CloudFlowEstimator::estimate (const std::vector<Eigen::Vector3f>& source,
                              const std::vector<Eigen::Vector3f>& target,
                              const RigidPose& start,
                              const std::vector<int>& segments,
                              const CloudBrightness& brightness) const
{
  const auto begin = std::chrono::steady_clock::now();
  const int threads = threadCount (solver_.threads);
  if (!(brightness.weight >= 0.0 && brightness.weight <= 1000.0))
    throw InvalidInput ("the weight of brightness is not in [0, 1000]");
  Tuning tuning = currentTuning();
  tuning.points.brightness.weight *= brightness.weight;
  tuning.points.brightness.part_weight *= brightness.weight;
  SolveProgress progress (solver_, kSteps);
  const GivenSegments given = numberSegments (segments, source);
  PointClouds clouds = preparePointClouds (source, target, tuning, threads, given.of);
  addTextures (brightness,
               source.size(),
               target.size(),
               tuning.points.brightness,
               threads,
               clouds);
  const PriorKnowledge prior =
      priorKnowledge (constraints_, clouds, given, source, target, tuning.points.match);
  const double segment_seconds = secondsSince (begin);
  const auto solve_from = [&] {
    auto solve = std::make_unique<PointSolve> (
        clouds, prior, clouds.scaled (start), tuning, threads, progress);
    solve->run();
    return solve;
  };
  std::unique_ptr<PointSolve> solve = solve_from();
  if (!solve->brightnessAgrees() && !progress.stopped()) {
    dropTextures (clouds);
    solve = solve_from();
  }
  const double solve_seconds = secondsSince (begin) - segment_seconds;
  CloudFlow flow = makeCloudFlow (clouds,
                                  prior,
                                  given,
                                  *solve,
                                  source,
                                  solver_.merge_bodies,
                                  tuning.points,
                                  threads);
  noteOutcome (progress, tuning.points.result, flow);
  flow.report.segment_seconds = segment_seconds;
  flow.report.solve_seconds = solve_seconds;
  flow.report.result_seconds = secondsSince (begin) - segment_seconds - solve_seconds;
  return flow;
}

} // namespace pcl_msf
