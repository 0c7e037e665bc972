// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "kernel_speed.h"
#include "measure.h"

#include <string>
#include <vector>

namespace pcl_msf::benchmarks {

/** \brief All that is told. */
struct BenchReport {
  std::string pair; ///< what was registered
  int width, height;
  std::string processor;
  unsigned processors; ///< that this process may use
  std::vector<Measured> methods;
  std::vector<KernelSpeed> kernels; ///< may be empty
};

/** \brief Markdown for a terminal: a table of methods with their stages, one of
 * kernels. */
std::string
tableText (const BenchReport& report);

/** \brief The same as JSON; seconds, bytes, shares; what is unknown is null. */
std::string
jsonText (const BenchReport& report);

} // namespace pcl_msf::benchmarks
