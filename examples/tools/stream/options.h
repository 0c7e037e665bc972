// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/player_settings.h"

#include <string>

namespace pcl_msf::tool {

/** \brief Everything that the command line of pcl_msf_stream says. */
struct StreamOptions : PlayerSettings {
  std::string output; ///< folder; empty = nothing is written
  bool flow{false};   ///< written, too
  bool quiet{false};
};

constexpr const char* kStreamSummary =
    "Scene flow of a camera, or a recording that is played as one would deliver it.\n\n"
    "  pcl_msf_stream SOURCE [--output DIR] [--flow]\n"
    "  pcl_msf_stream SOURCE --as-fast-as-possible [--output DIR]\n"
    "  pcl_msf_stream SOURCE --grabber pcd|image    files, read by PCL's grabbers\n"
    "  pcl_msf_stream [SOURCE] --grabber openni2|realsense2    a live camera\n\n"
    "SOURCE is a recording (color_K.png, depth_K.png and camera.txt), a folder of\n"
    "organized .pcd files, or one of the data sets' layouts (TUM RGB-D, ...), whose "
    "rgb.txt\n"
    "will do. For --grabber pcd it is a folder or a list of .pcd files, for image a "
    "folder\n"
    "with rgb and depth in the names of its images, or of .pclzf files; for a camera "
    "its\n"
    "number, as #1, or serial number, when there are several.\n"
    "Frames that come while others are solved are dropped, and counted.\n"
    "DIR gets trajectory.txt (TUM format, without lost frames), report.json and, with\n"
    "--flow, flow_A_B.flo. Ctrl-C ends the stream; what was computed is written.\n"
    "Exit status: 0 = all frames that were not dropped were tracked, 3 = some were "
    "lost\n"
    "(stderr says why), 128 + its number after a signal, else an error.";

/** \brief Adds the options to a command line, which checks them when it is read; it
 * throws UsageError then. */
void
declareStreamOptions (CLI::App& app, StreamOptions& options);

} // namespace pcl_msf::tool
