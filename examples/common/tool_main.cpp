// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/tool_main.h"

#include <pcl/console/print.h>

#include <opencv2/core/utils/logger.hpp>

#include "common/interruption.h"

#include <algorithm>
#include <cstdio>
#include <exception>

namespace pcl_msf::tool {

void
complain (const std::string& program, std::string message)
{
  std::replace (message.begin(), message.end(), '\n', ' ');
  std::fprintf (stderr, "%s: %s\n", program.c_str(), message.c_str());
}

int
runTool (const std::string& program, const std::function<int()>& work)
{
  cv::utils::logging::setLogLevel (cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    return work();
  }
  catch (const Interrupted& e) {
    complain (program, e.what());
    return interruptedStatus();
  }
  catch (const std::exception& e) {
    complain (program, e.what());
    return 1;
  }
}

void
beginWork ()
{
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  noteSignals();
}

} // namespace pcl_msf::tool
