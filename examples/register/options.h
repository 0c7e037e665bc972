// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include <pcl_msf/parameters.h>

#include <string>

namespace pcl_msf::tool {

/** \brief Everything that the command line says. */
struct RegisterOptions {
  std::string source; ///< file
  std::string target; ///< file
  std::string output; ///< folder
  bool quiet{false};
  bool help{false};
  SolverParameters solver;
};

/** \brief Reads the command line. \throws UsageError */
RegisterOptions
parseRegisterOptions (int argc, const char* const* argv);

/** \brief Prints what the tool does and all options with their defaults. */
void
printRegisterHelp (const char* program);

} // namespace pcl_msf::tool
