// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Pictures of a scene flow in 3-D: result folders or frames in, PNG files out.
#include <pcl/console/print.h>

#include <opencv2/core/utils/logger.hpp>

#include "common/interruption.h"
#include "common/tool_main.h"
#include "render/inputs.h"
#include "render/options.h"
#include "render/pictures.h"
#include <pcl_msf/io/folders.h>

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
    io::makeFolder (options.output); // before the work: it may be the wrong one
    const RenderInputs inputs = loadRenderInputs (options);
    for (const std::string& file : writeRenders (inputs, options))
      if (!options.quiet)
        std::printf ("%s\n", file.c_str());
    return 0;
  }
  catch (const std::exception& e) {
    complain ("pcl_msf_render", e.what());
    return interrupted() ? interruptedStatus() : 1;
  }
}
