// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// A live window on a scene flow: results or a sequence that is being solved.
#include "common/command_line.h"
#include "common/default_estimation.h"
#include "common/depth_check.h"
#include "common/interruption.h"
#include "common/outcome_text.h"
#include "common/player/open_source.h"
#include "common/recordings.h"
#include "common/result_folder.h"
#include "common/tool_main.h"
#include "view/sequence_solver.h"
#include "view/stream_solver.h"
#include "view/window.h"
#include <CLI/App.hpp>
#include <pcl_msf/visualization/virtual_display.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

/** `source` is a result folder or a folder with frames. */
struct ViewOptions : PlayerSettings {
  std::string sequence; ///< a folder with the frames of a result folder
  bool stream{false};   ///< played into the tracker
};

constexpr const char* kSummary =
    "A live window: clouds, segments, the warp and displacement arrows.\n\n"
    "  pcl_msf_view FOLDER     frames; every one is solved to the next\n"
    "  pcl_msf_view FOLDER --stream             played as a camera would, and tracked\n"
    "  pcl_msf_view --stream --grabber openni2  a live camera, or as pcl_msf_stream\n"
    "  pcl_msf_view RESULT --sequence FOLDER    what pcl_msf_scene_flow wrote";

void
declareOptions (CLI::App& app, ViewOptions& options)
{
  addText (app, "FOLDER", "PATH", "frames, or a result", options.source);
  auto* sequence = addText (
      app, "--sequence", "FOLDER", "frames of a result folder", options.sequence);
  auto* stream = addFlag (app,
                          "--stream",
                          "play the frames at their rate into the tracker and show the "
                          "newest",
                          options.stream)
                     ->excludes (sequence);
  addRateOption (app, options)->needs (stream);
  addGrabberOption (app, options)->needs (stream);
  addReadingOptions (app, options.reading);
  options.halve_large = true;
  app.final_callback ([&options] { checkSource (options, "FOLDER"); });
  app.footer (std::string ("Keys:\n") + ViewWindow::keys());
}

/** Every pair that pcl_msf_scene_flow wrote. */
SequenceSolver::Maker
resultMaker (const ViewOptions& options, std::vector<ResultPair> pairs)
{
  if (options.sequence.empty())
    throw UsageError ("--sequence: missing; a result is shown with its frames");
  const auto frames = openFrames (options.sequence, options.reading);
  return [folder = options.source, frames, pairs] (int pair,
                                                   const std::function<bool()>&) {
    visualization::ResultClouds result = readResult (folder, pairs[pair]);
    requireFrame (*frames, pairs[pair].current);
    takeCurrent (frames->frame (pairs[pair].current), result);
    return result;
  };
}

void
warn (int frame, const std::string& problem)
{
  if (!problem.empty())
    complain ("pcl_msf_view",
              "warning: frame " + std::to_string (frame) + ": " + problem);
}

/** Every frame to the next. */
SequenceSolver::Maker
pairMaker (std::shared_ptr<const io::RgbdSequence> frames, std::optional<double> scale)
{
  auto reference = std::make_shared<io::RgbdImages> (frames->frame (0));
  if (!reference->note.empty())
    warn (0, reference->note);
  const DepthUnit unit{scale, frames->definesDepthUnit()};
  warn (0, checkDepth (reference->depth, {}, "depth", unit));
  return [=] (int pair, const std::function<bool()>& go_on) {
    io::RgbdImages current = frames->frame (pair + 1);
    warn (pair + 1, checkDepth (current.depth, {}, "depth", unit));
    visualization::ResultClouds result = estimatePair (*reference, current, go_on);
    warn (pair + 1, problemOf (result.scene_flow.report));
    *reference = std::move (current);
    return result;
  };
}

std::shared_ptr<const io::RgbdSequence>
openTwoOrMore (const ViewOptions& options)
{
  auto frames = openFramesNotResults (options.source, options.reading);
  if (frames->frames() < 2)
    throw UsageError ("'" + options.source + "': holds one frame; two are needed");
  return frames;
}

/** What there is to show. */
struct Pairs {
  int count;
  SequenceSolver::Maker make;
};

Pairs
openPairs (const ViewOptions& options)
{
  const std::vector<ResultPair> pairs = resultPairs (options.source);
  if (!pairs.empty())
    return {static_cast<int> (pairs.size()), resultMaker (options, pairs)};
  const auto frames = openTwoOrMore (options);
  return {frames->frames() - 1, pairMaker (frames, options.reading.depth_scale)};
}

using Begin = std::function<std::unique_ptr<ResultSource>()>;

/** Reads what there is; solving begins when that is called. */
Begin
open (const ViewOptions& options)
{
  if (!options.stream)
    return [pairs = openPairs (options)] {
      return std::make_unique<SequenceSolver> (pairs.count, pairs.make);
    };
  const Warn warn_of_stream = [] (const std::string& text) {
    complain ("pcl_msf_view", "warning: " + text);
  };
  // Solvers begin once; functions are copied.
  auto source = std::make_shared<std::unique_ptr<FrameSource>> (
      openSource (options, warn_of_stream, openFramesNotResults));
  return [&options, source, warn_of_stream] {
    return std::make_unique<StreamSolver> (
        std::move (*source), options, warn_of_stream);
  };
}

/** Is there something to look at, or will there be? */
bool
isOfUse (const ResultSource& source)
{
  return source.problem().empty() || source.solved() > 0;
}

int
run (const ViewOptions& options)
{
  const Begin begin = open (options);
  std::shared_ptr<void> display; // is there as long as the window
  const std::string problem = visualization::displayProblem (&display);
  if (!problem.empty())
    throw UsageError (problem + "; a live window needs one; pcl_msf_render makes "
                                "pictures without");
  const std::unique_ptr<ResultSource> source = begin();
  ViewWindow window (*source);
  while (!interrupted() && isOfUse (*source) && window.spin()) {
  }
  if (!source->problem().empty() && !interrupted())
    throw std::runtime_error (source->problem());
  return interrupted() ? interruptedStatus() : 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<ViewOptions> (
      {"pcl_msf_view", kSummary, declareOptions, run}, argc, argv);
}
