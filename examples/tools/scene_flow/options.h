// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/method_options.h"
#include "common/shard.h"
#include <pcl_msf/lens_distortion.h>
#include <pcl_msf/pinhole_camera.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Kinds of files that are written; the report always is. */
enum class Output {
  Flow,       ///< flow_A_B.flo
  Cloud,      ///< scene_flow_A_B.pcd
  Warped,     ///< warped_A_B.pcd
  Visibility, ///< visibility_A_B.png and visible_A_B.png
  Labels,     ///< labels_A.png and bodies_A.png
  Poses,      ///< of windows of more than two frames: poses_A.yaml and .json
  Pictures    ///< everything that is there to be looked at
};

/** \brief Everything that the command line says. */
struct Options : WindowSettings {
  std::vector<std::string> color; ///< two files or more, or none
  std::vector<std::string> depth; ///< two files or more, or none with clouds
  std::vector<std::string> cloud; ///< two files or more, or none with images
  std::string sequence;           ///< a recording's folder in place of files
  int reference{0};               ///< place in the window
  bool track{false};              ///< frame by frame, the reference is kept
  std::optional<PinholeCamera> camera;
  std::optional<LensDistortion> distortion; ///< that images are freed from
  std::optional<double> depth_scale;        ///< units per metre
  double max_time_difference{0.02}; ///< of images that a recording pairs, seconds
  std::string output;               ///< folder; empty with a sequence = named after it
  std::vector<Output> outputs{Output::Flow,
                              Output::Cloud,
                              Output::Warped,
                              Output::Visibility,
                              Output::Labels,
                              Output::Poses,
                              Output::Pictures};
  std::string labels;       ///< label image in place of the segmentation
  double flow_maximum{0.0}; ///< of the flow colours, pixels; 0 = automatic
  Shard shard;
  bool shard_given{false};
  bool merge{false};    ///< of the shards in `output`
  std::string settings; ///< what of the command line results depend on, as one line
  bool quiet{false};

  /** \brief Is this run a part of one? */
  bool
  sharded () const
  {
    return shard_given;
  }

  bool
  wants (Output output) const
  {
    return std::find (outputs.begin(), outputs.end(), output) != outputs.end();
  }
};

constexpr const char* kSummary =
    "Piecewise-rigid scene flow between RGB-D frames.\n\n"
    "  pcl_msf_scene_flow --color C0.png --depth D0.png --color C1.png --depth D1.png\n"
    "    --camera FX,FY,CX,CY --depth-scale S --output DIR\n"
    "  pcl_msf_scene_flow --cloud A.pcd --cloud B.pcd [--camera FX,FY,CX,CY] "
    "--output DIR\n"
    "  pcl_msf_scene_flow FOLDER [--window N] [--track] [--output DIR]\n"
    "  pcl_msf_scene_flow FOLDER --shard I/N --output DIR, then --merge --output "
    "DIR\n\n"
    "Give --color, --depth or --cloud once a frame, in the order of time. FOLDER is a\n"
    "recording: color_K.png, depth_K.png and camera.txt, or one of the data sets'\n"
    "layouts (TUM RGB-D, ...). Exit status: 0 = written and converged, 3 = written "
    "but\n"
    "not converged (stderr says why), else an error.";

/** \brief Adds the options to a command line, which checks them when it is read; it
 * throws UsageError then. */
void
declareOptions (CLI::App& app, Options& options);

} // namespace pcl_msf::tool
