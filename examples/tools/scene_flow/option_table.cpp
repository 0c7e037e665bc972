// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "option_table.h"

#include "common/ranges.h"
#include "common/recordings.h"

namespace pcl_msf::tool {

namespace {

void
addInputOptions (CLI::App& app, Options& o)
{
  addText (app, "FOLDER", "PATH", "a recording in place of files", o.sequence);
  beginGroup (app, "Input and output");
  auto* color =
      addTexts (app, "--color", "FILE", "colour or grey image; once a frame", o.color);
  auto* depth = addTexts (app,
                          "--depth",
                          "FILE",
                          "depth image, 16-bit PNG, .dpt, .pfm or float .tiff; once a "
                          "frame",
                          o.depth);
  addTexts (app,
            "--cloud",
            "FILE",
            "organized .pcd in place of --color and --depth; once a frame",
            o.cloud)
      ->excludes (color)
      ->excludes (depth);
  addCamera (app, "pinhole camera, pixels; fitted to clouds when not given", o.camera);
  addDistortion (app,
                 "lens distortion, taken out of the images; OpenCV's order [a "
                 "recording's own]",
                 o.distortion)
      ->excludes (app.get_option ("--cloud"));
  addDepthScale (app,
                 "units per metre of depth images or clouds [1000 for 16 bit, else 1]",
                 o.depth_scale);
  addMaxTimeDifference (
      app, "between colour and depth images of a recording", o.max_time_difference);
  addText (app,
           "--labels",
           "FILE",
           "16-bit label image in place of a segmentation; 65535 = none; labels_0.png "
           "numbers its labels anew, 0, 1, ... in ascending order",
           o.labels);
  addText (app,
           "--output",
           "DIR",
           "folder for the results, made when missing [of FOLDER: its name and "
           "_scene_flow, in the current folder, never inside FOLDER]",
           o.output);
  addWords<Output> (app,
                    "--outputs",
                    "what is written beside the report",
                    o.outputs,
                    {{"flow", Output::Flow},
                     {"cloud", Output::Cloud},
                     {"warped", Output::Warped},
                     {"visibility", Output::Visibility},
                     {"labels", Output::Labels},
                     {"poses", Output::Poses},
                     {"pictures", Output::Pictures}});
  addNumber (
      app, "--flow-max", "PX", "flow of full colour, 0 = automatic", o.flow_maximum)
      ->check (atLeast (0));
  addFlag (app, "--quiet", "print errors and warnings only", o.quiet);
  addShard (app, o.shard);
  addFlag (app, "--merge", "join all shards that are in --output", o.merge)
      ->excludes (app.get_option ("--shard"));
}

void
addWindowOptions (CLI::App& app, Options& o)
{
  beginGroup (app, "Windows of more than two frames");
  addNumber (app,
             "--window",
             "N",
             "frames solved jointly; 0 = all files, 4 of a folder",
             o.window);
  auto* reference = addNumber (app,
                               "--reference",
                               "K",
                               "frame of the window whose points are followed",
                               o.reference)
                        ->check (atLeast (0));
  addFlag (app,
           "--track",
           "frame by frame; a reference stays while it explains the frames",
           o.track)
      ->excludes (reference)
      ->excludes (app.get_option ("--labels"))
      ->excludes (app.get_option ("--shard"));
  addMultiframeOptions (app, o);
}

} // namespace

void
addSceneFlowOptions (CLI::App& app, Options& options)
{
  addInputOptions (app, options);
  addMethodOptions (app, options);
  addWindowOptions (app, options);
  app.get_option ("--labels")
      ->excludes (app.get_option ("--segmentation"))
      ->excludes (app.get_option ("--rigid"));
}

} // namespace pcl_msf::tool
