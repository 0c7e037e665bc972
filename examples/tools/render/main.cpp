// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Pictures of a scene flow in 3-D: result folders or frames in, PNG files out.
#include <pcl/console/print.h>

#include <opencv2/core/utils/logger.hpp>

#include "common/input_files.h"
#include "common/interruption.h"
#include "common/output_folder.h"
#include "common/tool_main.h"
#include "render/inputs.h"
#include "render/options.h"
#include "render/pictures.h"

#include <cstdio>
#include <exception>

using namespace pcl_msf;
using namespace pcl_msf::tool;

int
main (int argc, char** argv)
{
  // Libraries' own messages would stand beside the one line that this tool promises.
  cv::utils::logging::setLogLevel (cv::utils::logging::LOG_LEVEL_SILENT);
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  try {
    if (argc < 2) {
      printRenderHelp();
      return 1;
    }
    const RenderOptions options = parseRenderOptions (argc, argv);
    if (options.help) {
      printRenderHelp();
      return 0;
    }
    noteSignals();
    for (const std::string& recording : {options.input, options.sequence})
      if (resultPairs (recording).empty())
        requireOutside ("--output", options.output, recording);
    // Before the work: it may be the wrong one.
    OutputFolder output (options.output, "pcl_msf_render", resultOf (options));
    prepareOutput (options, output);
    for (const std::string& file :
         writeRenders (loadRenderInputs (options), options, output))
      if (!options.quiet)
        std::printf ("%s\n", file.c_str());
    return 0;
  }
  catch (const std::exception& e) {
    complain ("pcl_msf_render", e.what());
    return interrupted() ? interruptedStatus() : 1;
  }
}
