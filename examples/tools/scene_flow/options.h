// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include "common/method_options.h"
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/pinhole_camera.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Which files are written; the report always is. */
struct Outputs {
  bool flow{true};       ///< flow_A_B.flo
  bool cloud{true};      ///< scene_flow_A_B.pcd
  bool warped{true};     ///< warped_A_B.pcd
  bool visibility{true}; ///< visibility_A_B.png and visible_A_B.png
  bool labels{true};     ///< labels_A.png and bodies_A.png
  bool poses{true};      ///< of windows of more than two frames: poses_A.yaml, .json
  bool pictures{true};   ///< everything that is there to be looked at
};

/** \brief Everything that the command line says. */
struct Options : MethodSettings {
  std::vector<std::string> color; ///< two files or more, or none
  std::vector<std::string> depth; ///< two files or more, or none with clouds
  std::vector<std::string> cloud; ///< two files or more, or none with images
  std::string sequence;           ///< a recording's folder in place of files
  int window{0};                  ///< frames solved jointly; 0 = all files, or 4
  int reference{0};               ///< place in the window
  bool rigid{false};              ///< the whole scene is one body
  bool track{false};              ///< frame by frame, the reference is kept
  std::optional<PinholeCamera> camera;
  std::optional<double> depth_scale; ///< units per metre
  double max_time_difference{0.02};  ///< of images that a recording pairs, seconds
  std::string output;                ///< folder; empty with a sequence = named after it
  Outputs outputs;
  std::string labels;       ///< label image in place of the segmentation
  double flow_maximum{0.0}; ///< of the flow colours, pixels; 0 = automatic
  bool quiet{false};
  bool help{false};
  MultiframeParameters multiframe;
};

/** \brief Reads the command line. \throws UsageError */
Options
parseOptions (int argc, const char* const* argv);

/** \brief Prints what the tool does and all options with their defaults. */
void
printHelp (const char* program);

} // namespace pcl_msf::tool
