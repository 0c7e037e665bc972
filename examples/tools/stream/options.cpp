// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "stream/options.h"

#include "common/ranges.h"
#include "common/recordings.h"
#include <CLI/App.hpp>
#include <pcl_msf/scene_flow_tracker.h>

#include <filesystem>

namespace pcl_msf::tool {

namespace {

void
addSourceOptions (CLI::App& app, StreamOptions& o)
{
  addText (app, "SOURCE", "PATH", "a recording, or a camera's number", o.source);
  beginGroup (app, "Input and output");
  addGrabberOption (app, o);
  addReadingOptions (app, o.reading);
  addMaxTimeDifference (app,
                        "between colour and depth images of a recording",
                        o.reading.max_time_difference);
  auto* rate = addRateOption (app, o);
  addFlag (app,
           "--as-fast-as-possible",
           "every frame once the one before is solved; none is dropped",
           o.every_frame)
      ->excludes (rate);
  addNumber (app, "--queue", "N", "frames that may wait for the solver", o.queue)
      ->check (atLeast (1));
  auto* output = addText (
      app, "--output", "DIR", "folder for the results, made when missing", o.output);
  addFlag (app, "--flow", "write the optical flow of every frame, too", o.flow)
      ->needs (output);
  addFlag (app, "--quiet", "print errors and warnings only", o.quiet);
}

void
checkWindow (int window)
{
  TrackerParameters tracker;
  tracker.window = window;
  std::string why;
  if (!tracker.isValid (&why))
    throw UsageError ("--" + why);
}

/** A list stands for the recording that it is of. */
std::string
folderOf (const std::string& source)
{
  const std::filesystem::path path = source;
  const bool list = path.filename() == "rgb.txt" || path.filename() == "depth.txt";
  if (!list || !std::filesystem::is_regular_file (path))
    return source;
  return path.has_parent_path() ? path.parent_path().string() : ".";
}

} // namespace

void
declareStreamOptions (CLI::App& app, StreamOptions& options)
{
  addSourceOptions (app, options);
  addMethodOptions (app, options);
  beginGroup (app, "Tracking");
  addNumber (app,
             "--window",
             "N",
             "frames solved jointly, 2 to 16; 0 = each follows the reference: faster",
             options.window);
  addMultiframeOptions (app, options);
  CLI::Option* finest = app.get_option ("--finest-level");
  finest->default_str ("0, of frames followed with 480 columns or more 1");
  app.final_callback ([&app, &options, finest] {
    options.halve_large = finest->count() == 0 && options.window == 0;
    checkSettings (app, options);
    checkWindow (options.window);
    checkSource (options, "SOURCE");
    if (options.grabber == GrabberKind::None)
      options.source = folderOf (options.source);
  });
}

} // namespace pcl_msf::tool
