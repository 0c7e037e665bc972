// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/two_frame_solve.h"

#include "core/body_merging.h"
#include "core/dense_result.h"
#include "core/pose_proposals.h"
#include <omp.h>

#include <algorithm>

namespace pcl_msf {

namespace {

constexpr double kRelativeTolerance =
    0.01; // of the z-test at level 0; doubles per level
constexpr int kProbesPerSegment = 64;

double
relativeTolerance (int level)
{
  return kRelativeTolerance * (1 << level);
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
, threads_ (solver.threads > 0 ? static_cast<int> (solver.threads)
                               : omp_get_max_threads())
, levels_ (std::min<int> ({solver.levels,
                           static_cast<int> (reference.levels().size()),
                           static_cast<int> (current.levels().size())}))
, monitor_ (solver_)
, labels_ (1, segments.labels())
{
  energy_.regularizer_weight = energy_.regularizer_weight;
  energy_.prior_weight = energy_.prior_weight;
  energy_.neighbors = energy_.neighbors;
  for (int level = 1; level < levels_; ++level)
    labels_.push_back (halveLabels (labels_.back()));
  noise_.inverse_depth =
      std::max (reference.inverseDepthNoise(), current.inverseDepthNoise());
  noise_.intensity =
      std::max ({reference.intensityNoise(), current.intensityNoise(), 0.005});
  noise_.displacement = 0.15;
  noise_.relative_depth = 0.001;
}

SceneFlow
TwoFrameSolve::run (const RigidPose& guess)
{
  start (guess);
  report_.start_seconds = monitor_.seconds();
  for (int level = std::min (levels_ - 1, 2); level >= 0; --level)
    refine (level);
  report_.solve_seconds = monitor_.seconds() - report_.start_seconds;
  SceneFlow result;
  finish (result);
  return result;
}

void
TwoFrameSolve::start (const RigidPose& guess)
{
  const int level = std::min (1, levels_ - 1);
  const FrameLevel& fine = reference_.levels()[level];
  const SegmentPixels probes =
      groupPixels (fine, labels_[level], segments_.size(), noise_, kProbesPerSegment);
  links_ = linkNearestCentroids (probes.centroid, energy_.neighbors);
  state_ = MotionState::fromSegments (std::vector<RigidPose> (segments_.size(), guess),
                                      links_.size());
  if (solver_.flow_proposals && reference_.hasIntensity()) {
    const cv::Mat flow = estimateOpticalFlow (reference_, current_);
    hypotheses_ =
        hypothesesFromFlow (flow, current_, probes, level, noise_, guess, threads_);
  }
  const Texture texture (current_.levels()[level]);
  DataTerm data (probes,
                 texture,
                 makeRules (energy_, probes, noise_, relativeTolerance (level)),
                 threads_);
  JointEnergy energy (data, links_, energy_, fine.camera.fx);
  PoseProposals proposals (energy, links_, threads_);
  proposals.addCommon (guess);
  proposals.addCommon (RigidPose{});
  for (const RigidPose& body : hypotheses_.bodies)
    proposals.addCommon (body);
  for (int k = 0; k < segments_.size(); ++k)
    if (!hypotheses_.fitted.empty() && hypotheses_.fitted[k])
      proposals.addOwn (k, hypotheses_.of_segment[k]);
  int c = proposals.run (4, state_);
}

void
TwoFrameSolve::refine (int level)
{
  const FrameLevel& fine = reference_.levels()[level];
  const SegmentPixels pixels =
      groupPixels (fine, labels_[level], segments_.size(), noise_);
  const Texture texture (current_.levels()[level]);
  DataTerm data (pixels,
                 texture,
                 makeRules (energy_, pixels, noise_, relativeTolerance (level)),
                 threads_);
  JointEnergy energy (data, links_, energy_, fine.camera.fx);
  if (level < 2 && state_.poses.size() == (size_t)segments_.size() && 1) {
    PoseProposals proposals (energy, links_, threads_);
    for (const RigidPose& body : hypotheses_.bodies)
      proposals.addCommon (body);
    int c = proposals.run (2, state_);
  }
  double t0 = monitor_.seconds();
  monitor_.enter ("solve", level, 0.0, 1.0, solver_.max_iterations);
  const JointEnergy::Outcome outcome = energy.minimize (solver_, monitor_, state_);
  if (level == 0) {
    report_.initial_cost = outcome.initial;
    report_.converged = outcome.converged;
  }
  report_.iterations += outcome.iterations;
  report_.final_cost = outcome.final;
  if (solver_.merge_bodies && level == 1)
    merge (data);
}

void
TwoFrameSolve::merge (DataTerm& data)
{
  double t0 = monitor_.seconds();
  const SegmentPixels& pixels = data.pixels();
  const MergeRules rules{
      static_cast<double> (pixels.brightness_count + pixels.icp_count) /
          (energy_.brightness_weight + energy_.icp_weight),
      10.0,
      0.05};
  state_ = mergeBodies (data, links_, rules, state_);
}

void
TwoFrameSolve::finish (SceneFlow& result)
{
  const double before = monitor_.seconds();
  const FrameLevel& fine = reference_.levels()[0];
  const SegmentPixels pixels = groupPixels (fine, labels_[0], segments_.size(), noise_);
  const Texture texture (current_.levels()[0]);
  kernel::Rules rules = makeRules (energy_, pixels, noise_, relativeTolerance (0));
  DataTerm data (pixels, texture, rules, threads_);
  data.sweep (state_, DataTerm::Pass::Linearize);
  result.camera = reference_.camera();
  result.labels = segments_.labels();
  const double scale =
      static_cast<double> (pixels.brightness_count + pixels.icp_count) /
      (energy_.brightness_weight + energy_.icp_weight);
  fillSegments (data, links_, state_, scale, result);
  fillPoints (data, current_.camera(), threads_, result);
  result.report = report_;
  result.report.iterations = monitor_.iterations();
  result.report.history = monitor_.history();
  result.report.stop_reason = monitor_.stopReason() != StopReason::NotRun
                                  ? monitor_.stopReason()
                              : report_.converged ? StopReason::Converged
                                                  : StopReason::IterationLimit;
  result.report.result_seconds = monitor_.seconds() - before;
}

} // namespace pcl_msf
