// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// A live window on a scene flow: results or a sequence that is being solved.
#include <pcl/console/print.h>

#include <opencv2/core/utils/logger.hpp>

#include "common/command_line.h"
#include "common/default_estimation.h"
#include "common/interruption.h"
#include "common/option_values.h"
#include "common/recordings.h"
#include "common/tool_main.h"
#include "view/window.h"
#include <pcl_msf/visualization/virtual_display.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

CommandLine
makeCommandLine (RenderOptions& options)
{
  CommandLine line;
  line.summary = "A live window: clouds, segments, the warp and displacement arrows.";
  line.syntax = {
      "pcl_msf_view FOLDER     frames; every one is solved to the next",
      "pcl_msf_view RESULT --sequence FOLDER    what pcl_msf_scene_flow wrote"};
  line.options = {
      {"--sequence", "FOLDER", "frames of a result folder", text (options.sequence)},
      {"--help", "", "print this", flag (options.help)}};
  for (const Option& option : readingOptions (options.reading))
    line.options.insert (line.options.end() - 1, option);
  line.take_word = [&options] (const std::string& word) {
    if (!options.input.empty())
      throw UsageError ("'" + word + "': one input is enough; leave it away");
    options.input = word;
  };
  return line;
}

/** Every pair that pcl_msf_scene_flow wrote. */
SequenceSolver::Maker
resultMaker (RenderOptions options, std::vector<ResultPair> pairs)
{
  if (options.sequence.empty())
    throw UsageError ("--sequence: missing; a result is shown with its frames");
  openFrames (options.sequence, options.reading); // a wrong one is told at once
  return [options, pairs] (int pair, const std::function<bool()>&) {
    RenderOptions one = options;
    one.reference = pairs[pair].reference;
    one.frame = pairs[pair].current;
    return loadRenderInputs (one).result;
  };
}

/** Every frame to the next. */
SequenceSolver::Maker
pairMaker (std::shared_ptr<const io::RgbdSequence> frames)
{
  auto reference = std::make_shared<io::RgbdImages> (frames->frame (0));
  return [frames, reference] (int pair, const std::function<bool()>& go_on) {
    io::RgbdImages current = frames->frame (pair + 1);
    visualization::ResultClouds result = estimatePair (*reference, current, go_on);
    *reference = std::move (current);
    return result;
  };
}

std::unique_ptr<SequenceSolver>
makeSolver (const RenderOptions& options)
{
  const std::vector<ResultPair> pairs = resultPairs (options.input);
  if (!pairs.empty())
    return std::make_unique<SequenceSolver> (static_cast<int> (pairs.size()),
                                             resultMaker (options, pairs));
  const auto frames = openFrames (options.input, options.reading);
  return std::make_unique<SequenceSolver> (frames->frames() - 1, pairMaker (frames));
}

int
run (const RenderOptions& options)
{
  std::shared_ptr<void> display; // is there as long as the window
  const std::string problem = visualization::displayProblem (&display);
  if (!problem.empty())
    throw UsageError (problem + "; a live window needs one; pcl_msf_render makes "
                                "pictures without");
  noteSignals();
  const std::unique_ptr<SequenceSolver> solver = makeSolver (options);
  ViewWindow window (*solver);
  while (!interrupted() && window.spin()) {
  }
  if (!solver->problem().empty() && !interrupted())
    throw std::runtime_error (solver->problem());
  return interrupted() ? interruptedStatus() : 0;
}

} // namespace

int
main (int argc, char** argv)
{
  cv::utils::logging::setLogLevel (cv::utils::logging::LOG_LEVEL_SILENT);
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  try {
    RenderOptions options;
    const CommandLine line = makeCommandLine (options);
    line.read (argc, argv);
    if (options.help || options.input.empty()) {
      line.printHelp();
      std::printf ("\nKeys:\n%s", ViewWindow::keys());
      return options.help ? 0 : 1;
    }
    return run (options);
  }
  catch (const std::exception& e) {
    complain ("pcl_msf_view", e.what());
    return 1;
  }
}
