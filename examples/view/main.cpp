// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// A live window on a scene flow: results or a sequence that is being solved.
#include <pcl/console/print.h>

#include <opencv2/core/utils/logger.hpp>

#include "common/command_line.h"
#include "common/interruption.h"
#include "common/option_values.h"
#include "common/tool_main.h"
#include "render/inputs.h"
#include "view/window.h"
#include <pcl_msf/visualization/virtual_display.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>

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
  line.take_word = [&options] (const std::string& word) {
    if (!options.input.empty())
      throw UsageError ("'" + word + "': one input is enough; leave it away");
    options.input = word;
  };
  return line;
}

std::unique_ptr<SequenceSolver>
makeSolver (const RenderOptions& options)
{
  const std::filesystem::path input = options.input;
  if (!std::filesystem::exists (input / "scene_flow_0_1.pcd"))
    return std::make_unique<SequenceSolver> (io::DataFolder (options.input));
  if (options.sequence.empty())
    throw UsageError ("--sequence: missing; a result is shown with its frames");
  auto result =
      std::make_shared<visualization::ResultClouds> (loadRenderInputs (options).result);
  return std::make_unique<SequenceSolver> (std::move (result));
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
