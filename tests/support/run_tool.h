// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "support/temporary_folder.h"
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace pcl_msf::testing {

/** \brief How a command ended and what it printed. */
struct ToolRun {
  int status{-1};
  std::string out;
  std::string err;

  long
  errorLines () const
  {
    return std::count (err.begin(), err.end(), '\n');
  }
};

/** \brief Runs a command line of the shell as a user does. */
inline ToolRun
runTool (const TemporaryFolder& folder, const std::string& command)
{
  const std::string out = folder ("stdout.txt");
  const std::string err = folder ("stderr.txt");
  const int result = std::system ((command + " >" + out + " 2>" + err).c_str());
  return {
      WIFEXITED (result) ? WEXITSTATUS (result) : -1, readFile (out), readFile (err)};
}

/** \brief Is there a program of this name? */
inline bool
hasProgram (const std::string& name)
{
  return std::system (("command -v " + name + " >/dev/null").c_str()) == 0;
}

} // namespace pcl_msf::testing
