// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/methods/peak_memory.h"

#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

namespace pcl_msf::tool {

PeakMemory::PeakMemory()
{
  std::ofstream ("/proc/self/clear_refs") << "5"; // see man 5 proc
}

double
PeakMemory::megabytes() const
{
  std::ifstream status ("/proc/self/status");
  for (std::string line; std::getline (status, line);)
    if (line.rfind ("VmHWM:", 0) == 0)
      return std::strtod (line.c_str() + 6, nullptr) / 1024.0;
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace pcl_msf::tool
