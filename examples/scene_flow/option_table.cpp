// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "option_table.h"

#include "common/default_help.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

namespace {

Setter
append (std::vector<std::string>& files)
{
  return [&files] (const std::string& text) {
    files.push_back (text);
    return !text.empty();
  };
}

OptionGroup
inputOptions (Options& o)
{
  return {
      "Input and output",
      {{"--color", "FILE", "colour or grey image; once a frame", append (o.color)},
       {"--depth",
        "FILE",
        "depth image, 16-bit PNG, .dpt, .pfm or float .tiff; once a frame",
        append (o.depth)},
       {"--cloud",
        "FILE",
        "organized .pcd in place of --color and --depth; once a frame",
        append (o.cloud)},
       {"--camera",
        "FX,FY,CX,CY",
        "pinhole camera, pixels; fitted to clouds when not given",
        camera (o.camera)},
       {"--depth-scale",
        "S",
        "units per metre of depth images or clouds [1000 for 16 bit, else 1]",
        positive (o.depth_scale)},
       {"--max-time-difference",
        "S",
        withDefault ("between colour and depth images of a recording, seconds",
                     o.max_time_difference),
        positive (o.max_time_difference)},
       {"--labels",
        "FILE",
        "16-bit label image in place of a segmentation; 65535 = none",
        text (o.labels)},
       {"--output",
        "DIR",
        "folder for the results, made when missing",
        text (o.output)},
       numeric (
           "--flow-max", "PX", "flow of full colour, 0 = automatic", o.flow_maximum),
       {"--quiet", "", "print errors and warnings only", flag (o.quiet)},
       {"--help", "", "print this", flag (o.help)}}};
}

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

OptionGroup
windowOptions (Options& o)
{
  return {"Windows of more than two frames",
          {numeric ("--window",
                    "N",
                    "frames solved jointly; 0 = all files, 4 of a folder",
                    o.window),
           numeric ("--reference",
                    "K",
                    "frame of the window whose points are followed",
                    o.reference),
           {"--track",
            "",
            "frame by frame; a reference stays while it explains the frames",
            flag (o.track)},
           {"--rigid", "", "the whole scene is one rigid body", flag (o.rigid)},
           numeric ("--concatenation-weight",
                    "W",
                    "lambda of Eq. 14",
                    o.multiframe.concatenation_weight),
           numeric ("--max-span",
                    "N",
                    "leave out pairs of frames farther apart, 0 = none",
                    o.multiframe.max_span),
           switchable ("--static-background",
                       "the largest body is a rigid background",
                       o.multiframe.static_background)}};
}

} // namespace

std::vector<OptionGroup>
makeOptionTable (Options& options)
{
  return {inputOptions (options),
          frameOptions (options.frame),
          segmentationOptions (options.segmentation),
          energyOptions (options.energy),
          solverOptions (options.solver),
          windowOptions (options)};
}

} // namespace pcl_msf::tool
