// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Scene flow between two RGB-D frames: files in, files out.
#include <pcl/console/print.h>

#include <opencv2/core/utils/logger.hpp>

#include "interruption.h"
#include "options.h"
#include "output.h"
#include "pipeline.h"
#include <pcl_msf/io/folders.h>

#include <algorithm>
#include <cstdio>
#include <exception>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_scene_flow";

/** One line on stderr, whatever the message holds. */
void
complain (std::string message)
{
  std::replace (message.begin(), message.end(), '\n', ' ');
  std::fprintf (stderr, "%s: %s\n", kProgram, message.c_str());
}

void
printSummary (const Outcome& outcome, const std::string& folder)
{
  using namespace pcl::console;
  setVerbosityLevel (L_INFO);
  const io::RunSeconds& seconds = outcome.seconds;
  const SceneFlow& flow = outcome.scene_flow;
  print_highlight ("%zu segments, %d motion groups, %d iterations, %s\n",
                   flow.segments.size(),
                   flow.bodies,
                   flow.report.iterations,
                   toString (flow.report.stop_reason));
  print_info ("[done, ");
  print_value ("%.1f", 1000.0 * seconds.total);
  print_info (" ms: load ");
  print_value ("%.1f", 1000.0 * seconds.load);
  print_info (", frames ");
  print_value ("%.1f", 1000.0 * seconds.frame);
  print_info (", segments ");
  print_value ("%.1f", 1000.0 * seconds.segment);
  print_info (", solve ");
  print_value ("%.1f", 1000.0 * flow.report.solve_seconds);
  print_info ("; written to ");
  print_value ("%s", folder.c_str());
  print_info ("]\n");
}

int
run (const Options& options)
{
  io::makeFolder (options.output);
  Outcome outcome = runPipeline (options);
  writeOutcome (outcome, options);
  if (!options.quiet)
    printSummary (outcome, options.output);
  const Report& report = outcome.scene_flow.report;
  if (!report.converged)
    complain (std::string ("warning: not converged (") + toString (report.stop_reason) +
              ") " + report.message);
  return 0;
}

} // namespace

int
main (int argc, char** argv)
{
  // Libraries' own messages would stand beside the one line that this tool promises.
  cv::utils::logging::setLogLevel (cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    if (argc < 2) {
      printHelp (kProgram);
      return 1;
    }
    const Options options = parseOptions (argc, argv);
    if (options.help) {
      printHelp (kProgram);
      return 0;
    }
    pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
    noteSignals();
    return run (options);
  }
  catch (const Interrupted& e) {
    complain (e.what());
    return interruptedStatus();
  }
  catch (const std::exception& e) {
    complain (e.what());
    return 1;
  }
}
