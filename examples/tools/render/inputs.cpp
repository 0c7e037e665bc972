// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/inputs.h"

#include "common/default_estimation.h"
#include "common/depth_check.h"
#include "common/interruption.h"
#include "common/outcome_text.h"
#include "common/result_folder.h"
#include "common/tool_main.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/result_files.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

/** Last frame that pictures of the way through the window need; 0 = none does. */
int
lastOfWindow (const RenderOptions& options, int current)
{
  const auto& kinds = options.kinds;
  const bool paths =
      options.animation == Animation::Warp ||
      std::find (kinds.begin(),
                 kinds.end(),
                 visualization::PictureKind::Trajectories) != kinds.end();
  if (!paths)
    return 0;
  return options.window > 0 ? options.window : current;
}

/** The pair of a result that is asked for, or else its first. */
ResultPair
choosePair (const std::vector<ResultPair>& pairs, const RenderOptions& options)
{
  for (const ResultPair& pair : pairs)
    if (options.reference.value_or (pair.reference) == pair.reference &&
        options.frame.value_or (pair.current) == pair.current)
      return pair;
  const int reference = options.reference.value_or (pairs.front().reference);
  const int frame = options.frame.value_or (reference + 1);
  throw UsageError (options.input + ": there is no " +
                    sceneFlowName ({reference, frame}) + "; " +
                    sceneFlowName (pairs.front()) +
                    " is, --reference and --frame "
                    "choose");
}

/** A folder that pcl_msf_scene_flow wrote. */
RenderInputs
loadResult (const ResultPair& pair, const RenderOptions& options)
{
  const fs::path folder = options.input;
  RenderInputs inputs;
  inputs.result = readResult (options.input, pair);
  const SceneFlow& flow = inputs.result.scene_flow;
  if (!options.sequence.empty()) {
    const auto frames = openFrames (options.sequence, options.reading);
    requireFrame (*frames, pair.current);
    takeCurrent (frames->frame (pair.current), inputs.result);
  }
  const int window = lastOfWindow (options, pair.current);
  const int last = std::max (window, pair.current);
  for (int k = std::min (pair.reference + 1, pair.current); k <= last; ++k) {
    throwIfInterrupted();
    const std::string path = (folder / sceneFlowName ({pair.reference, k})).string();
    const bool wanted = options.window > 0 || fs::exists (path);
    if (k == pair.current)
      inputs.displacements.push_back (flow.displacement);
    else if (k > pair.reference && k <= window && wanted)
      inputs.displacements.push_back (
          io::readSceneFlowCloud (path).scene_flow.displacement);
  }
  return inputs;
}

/** Of the frames that matter most, for all. */
double
colorUnit (const io::RgbdImages& reference, const io::RgbdSequence& frames, int frame)
{
  if (reference.raw_color.empty())
    return 1.0;
  const io::RgbdImages current = frames.frame (frame);
  return io::colorUnit ({&reference, &current});
}

void
warn (const std::string& problem)
{
  if (!problem.empty())
    complain ("pcl_msf_render", "warning: " + problem);
}

std::string
nameOf (const RenderOptions& options, int frame)
{
  return options.input + ": frame " + std::to_string (frame);
}

/** A frame that is to be registered, and a line about what is uncertain in it. */
io::RgbdImages
readFrame (const io::RgbdSequence& frames, const RenderOptions& options, int frame)
{
  io::RgbdImages images = frames.frame (frame);
  const std::string name = nameOf (options, frame);
  if (!images.note.empty())
    warn (name + ": " + images.note);
  warn (checkDepth (images.depth,
                    {},
                    name,
                    {options.reading.depth_scale, frames.definesDepthUnit()}));
  return images;
}

/** A folder with frames: the scene flow is computed here. */
RenderInputs
estimate (const RenderOptions& options)
{
  const auto frames = openFramesNotResults (options.input, options.reading);
  if (fs::is_directory (fs::path (options.input) / frames->name()))
    throw UsageError (options.input +
                      ": neither scene_flow_R_K.pcd of "
                      "pcl_msf_scene_flow nor frames with camera.txt in it; give its "
                      "folder " +
                      frames->name());
  const int first = options.reference.value_or (0);
  const int current = options.frame.value_or (first + 1);
  const int window = lastOfWindow (options, current);
  const int last = std::max (window, current);
  requireFrame (*frames, std::max (first, last));
  if (current <= first)
    throw UsageError ("--frame: must come after --reference in a folder with frames");
  io::RgbdImages reference = readFrame (*frames, options, first);
  const double unit = colorUnit (reference, *frames, current);
  io::setColorUnit (reference, unit);
  const DefaultEstimation estimation (reference);
  RenderInputs inputs;
  inputs.result.reference_color = reference.color;
  for (int k = first + 1; k <= last; ++k) {
    if (k != current && k > window)
      continue;
    if (!options.quiet && isatty (STDERR_FILENO) != 0)
      std::fprintf (stderr, "scene flow from frame %d to %d\n", first, k);
    io::RgbdImages images = readFrame (*frames, options, k);
    io::setColorUnit (images, unit);
    SceneFlow flow = estimation.to (images, [] { return !interrupted(); });
    inputs.displacements.push_back (flow.displacement);
    const std::string problem = problemOf (flow.report);
    if (!problem.empty())
      warn (nameOf (options, first) + " to " + std::to_string (k) + ": " + problem);
    inputs.converged = inputs.converged && problem.empty();
    if (k == current) {
      inputs.result.scene_flow = std::move (flow);
      takeCurrent (images, inputs.result);
    }
  }
  return inputs;
}

} // namespace

RenderInputs
loadRenderInputs (const RenderOptions& options)
{
  if (!fs::is_directory (options.input))
    throw IoError (options.input +
                   ": folder: there is none of that name; check the path");
  const std::vector<ResultPair> pairs = resultPairs (options.input);
  return pairs.empty() ? estimate (options)
                       : loadResult (choosePair (pairs, options), options);
}

} // namespace pcl_msf::tool
