// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "option_table.h"

#include "common/default_help.h"

#include <algorithm>
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

/** Names parted by commas: these and no others. */
Setter
outputs (Outputs& wanted)
{
  return [&wanted] (const std::string& text) {
    wanted = {false, false, false, false, false, false, false};
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min (text.find (',', begin), text.size());
      const std::string word = text.substr (begin, end - begin);
      bool* const output = word == "flow"         ? &wanted.flow
                           : word == "cloud"      ? &wanted.cloud
                           : word == "warped"     ? &wanted.warped
                           : word == "visibility" ? &wanted.visibility
                           : word == "labels"     ? &wanted.labels
                           : word == "poses"      ? &wanted.poses
                           : word == "pictures"   ? &wanted.pictures
                                                  : nullptr;
      if (word == "all")
        wanted = {};
      else if (!output)
        return false;
      else
        *output = true;
      begin = end + 1;
    }
    return true;
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
       {"--outputs",
        "LIST",
        "of all, flow, cloud, warped, visibility, labels, poses, pictures: what is "
        "written beside the report [all]",
        outputs (o.outputs)},
       numeric (
           "--flow-max", "PX", "flow of full colour, 0 = automatic", o.flow_maximum),
       {"--quiet", "", "print errors and warnings only", flag (o.quiet)},
       {"--help", "", "print this", flag (o.help)}}};
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
  std::vector<OptionGroup> table = methodOptions (options);
  table.insert (table.begin(), inputOptions (options));
  table.push_back (windowOptions (options));
  return table;
}

} // namespace pcl_msf::tool
