// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/method_options.h"

#include "common/default_help.h"

namespace pcl_msf::tool {

namespace {

OptionGroup
frameOptions (FrameParameters& p)
{
  return {
      "Frames",
      {numeric (
           "--smoothing-sigma", "PX", "Gaussian on the intensity", p.smoothing_sigma),
       numeric ("--min-depth", "M", "nearer points are dropped", p.min_depth),
       numeric ("--max-depth", "M", "farther points are dropped", p.max_depth),
       numeric ("--max-levels", "N", "pyramid levels of a frame", p.max_levels),
       oneOf<NormalMethod> ("--normals",
                            p.normals,
                            {{"central", NormalMethod::CentralDifferences},
                             {"integral", NormalMethod::IntegralImage}})}};
}

OptionGroup
segmentationOptions (SegmentationParameters& p)
{
  using Method = SegmentationMethod;
  return {
      "Segments",
      {oneOf<Method> ("--segmentation",
                      p.method,
                      {{"tangent-plane", Method::TangentPlane},
                       {"felzenszwalb", Method::Felzenszwalb},
                       {"slic", Method::Slic},
                       {"tiles", Method::Tiles},
                       {"single", Method::Single}}),
       numeric ("--threshold", "T", "felzenszwalb's threshold", p.threshold),
       numeric ("--min-points", "N", "felzenszwalb's smallest segment", p.min_points),
       switchable (
           "--discard-small", "discard small segments, not merge", p.discard_small),
       numeric ("--segment-size", "PX", "aimed side of a segment", p.segment_size)}};
}

OptionGroup
energyOptions (EnergyParameters& p)
{
  return {
      "Energy",
      {numeric ("--brightness-weight", "W", "alpha", p.brightness_weight),
       numeric ("--icp-weight", "W", "beta", p.icp_weight),
       numeric ("--regularizer-weight", "W", "gamma", p.regularizer_weight),
       numeric ("--prior-weight", "W", "eta", p.prior_weight),
       numeric ("--huber-threshold",
                "E",
                "in standard deviations, 0 = l1",
                p.huber_threshold),
       oneOf<LossType> (
           "--loss",
           p.loss,
           {{"huber", LossType::Huber}, {"l1", LossType::L1}, {"l2", LossType::L2}}),
       oneOf<PoseDifference> ("--pose-difference",
                              p.pose_difference,
                              {{"metric", PoseDifference::Metric},
                               {"parameters", PoseDifference::Parameters}}),
       numeric ("--neighbors", "N", "connected segments of a segment", p.neighbors)}};
}

OptionGroup
solverOptions (SolverParameters& p)
{
  return {
      "Solver",
      {numeric ("--max-iterations", "N", "steps a level", p.max_iterations),
       numeric ("--function-tolerance", "T", "relative change", p.function_tolerance),
       numeric ("--parameter-tolerance", "T", "relative change", p.parameter_tolerance),
       numeric ("--max-seconds", "S", "time budget, 0 = none", p.max_seconds),
       oneOf<LinearSolver> (
           "--linear-solver",
           p.linear_solver,
           {{"cgnr", LinearSolver::Cgnr}, {"cholesky", LinearSolver::SparseCholesky}}),
       numeric ("--levels", "N", "pyramid levels to use", p.levels),
       switchable (
           "--flow-proposals", "start from optical flow, too", p.flow_proposals),
       switchable (
           "--blend-motions", "points follow connected segments, too", p.blend_motions),
       switchable ("--merge-bodies", "join what moves as one body", p.merge_bodies),
       numeric ("--threads", "N", "0 = all", p.threads)}};
}

} // namespace

std::vector<OptionGroup>
methodOptions (MethodSettings& settings)
{
  return {frameOptions (settings.frame),
          segmentationOptions (settings.segmentation),
          energyOptions (settings.energy),
          solverOptions (settings.solver)};
}

} // namespace pcl_msf::tool
