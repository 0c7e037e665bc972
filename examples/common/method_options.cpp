// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/method_options.h"

#include <opencv2/core.hpp>

#include <CLI/App.hpp>

#include <algorithm>

namespace pcl_msf::tool {

namespace {

void
addFrameOptions (CLI::App& app, FrameParameters& p)
{
  beginGroup (app, "Frames");
  addNumber (
      app, "--smoothing-sigma", "PX", "Gaussian on the intensity", p.smoothing_sigma);
  addNumber (app, "--min-depth", "M", "nearer points are dropped", p.min_depth);
  addNumber (app, "--max-depth", "M", "farther points are dropped", p.max_depth);
  addNumber (app, "--max-levels", "N", "pyramid levels of a frame", p.max_levels);
  addNumber (app,
             "--finest-level",
             "N",
             "halve frames so often first: 1 takes a third of the time",
             p.finest_level);
  addWord<NormalMethod> (app,
                         "--normals",
                         "of the reference",
                         p.normals,
                         {{"central", NormalMethod::CentralDifferences},
                          {"integral", NormalMethod::IntegralImage}});
}

void
addSegmentationOptions (CLI::App& app, SegmentationParameters& p)
{
  using Method = SegmentationMethod;
  beginGroup (app, "Segments");
  addWord<Method> (app,
                   "--segmentation",
                   "how the reference is cut",
                   p.method,
                   {{"tangent-plane", Method::TangentPlane},
                    {"felzenszwalb", Method::Felzenszwalb},
                    {"slic", Method::Slic},
                    {"tiles", Method::Tiles},
                    {"single", Method::Single}});
  addNumber (app, "--threshold", "T", "felzenszwalb's threshold", p.threshold);
  addNumber (app, "--min-points", "N", "felzenszwalb's smallest segment", p.min_points);
  addSwitch (
      app, "--discard-small", "discard small segments, not merge", p.discard_small);
  addNumber (app, "--segment-size", "PX", "aimed side of a segment", p.segment_size);
}

void
addEnergyOptions (CLI::App& app, EnergyParameters& p)
{
  beginGroup (app, "Energy");
  addNumber (app, "--brightness-weight", "W", "alpha", p.brightness_weight);
  addNumber (app, "--icp-weight", "W", "beta", p.icp_weight);
  addNumber (app, "--regularizer-weight", "W", "gamma", p.regularizer_weight);
  addNumber (app, "--prior-weight", "W", "eta", p.prior_weight);
  addNumber (app,
             "--huber-threshold",
             "E",
             "in standard deviations, 0 = l1",
             p.huber_threshold);
  addWord<LossType> (
      app,
      "--loss",
      "of the residuals",
      p.loss,
      {{"huber", LossType::Huber}, {"l1", LossType::L1}, {"l2", LossType::L2}});
  addWord<PoseDifference> (
      app,
      "--pose-difference",
      "of linked segments",
      p.pose_difference,
      {{"metric", PoseDifference::Metric}, {"parameters", PoseDifference::Parameters}});
  addNumber (app, "--neighbors", "N", "connected segments of a segment", p.neighbors);
}

void
addSolverOptions (CLI::App& app, SolverParameters& p)
{
  beginGroup (app, "Solver");
  addNumber (app, "--max-iterations", "N", "steps a level", p.max_iterations);
  addNumber (app, "--function-tolerance", "T", "relative change", p.function_tolerance);
  addNumber (
      app, "--parameter-tolerance", "T", "relative change", p.parameter_tolerance);
  addNumber (app, "--max-seconds", "S", "time budget, 0 = none", p.max_seconds);
  addWord<LinearSolver> (
      app,
      "--linear-solver",
      "of a step",
      p.linear_solver,
      {{"cgnr", LinearSolver::Cgnr}, {"cholesky", LinearSolver::SparseCholesky}});
  addNumber (app, "--levels", "N", "pyramid levels to use", p.levels);
  addSwitch (app, "--flow-proposals", "start from optical flow, too", p.flow_proposals);
  addSwitch (
      app, "--blend-motions", "points follow connected segments, too", p.blend_motions);
  addSwitch (app, "--refine-flow", "images move single points, too", p.refine_flow);
  addSwitch (app, "--merge-bodies", "join what moves as one body", p.merge_bodies);
  addNumber (app, "--threads", "N", "0 = all", p.threads);
}

template <typename Parameters>
void
checkParameters (const Parameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    return;
  for (char& c : why)
    c = c == '_' ? '-' : c;
  throw UsageError ("--" + why);
}

} // namespace

void
addMethodOptions (CLI::App& app, MethodSettings& settings)
{
  addFrameOptions (app, settings.frame);
  addSegmentationOptions (app, settings.segmentation);
  addEnergyOptions (app, settings.energy);
  addSolverOptions (app, settings.solver);
}

void
addMultiframeOptions (CLI::App& app, WindowSettings& settings)
{
  MultiframeParameters& p = settings.multiframe;
  addFlag (app, "--rigid", "the whole scene is one rigid body", settings.rigid);
  addNumber (
      app, "--concatenation-weight", "W", "lambda of Eq. 14", p.concatenation_weight);
  addNumber (app,
             "--max-span",
             "N",
             "leave out pairs of frames farther apart, 0 = none",
             p.max_span);
  addSwitch (app,
             "--static-background",
             "the largest body is a rigid background",
             p.static_background);
}

void
checkSettings (const CLI::App& app, WindowSettings& settings)
{
  checkParameters (settings.frame);
  checkParameters (settings.segmentation);
  if (settings.energy.brightness_weight == 0.0 && settings.energy.icp_weight == 0.0)
    throw UsageError ("--brightness-weight, --icp-weight: both are 0; give one of them "
                      "more, 1 for example");
  checkParameters (settings.energy);
  checkParameters (settings.solver);
  checkParameters (settings.multiframe);
  if (!settings.rigid)
    return;
  SegmentationMethod& method = settings.segmentation.method;
  if (app.count ("--segmentation") > 0 && method != SegmentationMethod::Single)
    throw UsageError ("--rigid: not together with --segmentation but 'single', for the "
                      "whole scene is one segment; give one of them");
  method = SegmentationMethod::Single;
}

void
limitThreads (const MethodSettings& settings)
{
  if (settings.solver.threads > 0)
    cv::setNumThreads (
        std::min (static_cast<int> (settings.solver.threads), cv::getNumberOfCPUs()));
}

} // namespace pcl_msf::tool
