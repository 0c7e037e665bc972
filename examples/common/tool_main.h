// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace pcl_msf::tool {

/** \brief One line on stderr, "program: message", whatever the message holds. */
void
complain (const std::string& program, const std::string& message);

/** \brief Runs `work` and returns its exit status. What it throws becomes one line on
 * stderr and the status 1, that of the signal after one. OpenCV's own messages
 * would stand beside that line and are turned off. A reader of stdout who goes away
 * ends nothing; see standard_streams.h. */
int
runTool (const std::string& program, const std::function<int()>& work);

/** \brief Reads a command line and does a tool's work: help without arguments (status
 * 1, and stderr says what is missing) or when asked for, else `run` with PCL's messages
 * off and signals noted. \return exit status \param declare adds the options \param
 * summary head of the help */
int
runWithOptions (const std::string& program,
                const std::string& summary,
                const std::function<void (CLI::App&)>& declare,
                const std::function<int()>& run,
                bool needs_arguments,
                int argc,
                const char* const* argv);

/** \brief What a tool with `Options` is made of. */
template <typename Options>
struct Tool {
  const char* program;
  const char* summary;                            ///< head of the help
  void (*declare) (CLI::App& app, Options& into); ///< adds the options
  int (*run) (const Options& options);
  bool needs_arguments{true}; ///< else help without any
};

/** \brief The main() of a tool. Returns the exit status. */
template <typename Options>
int
toolMain (const Tool<Options>& tool, int argc, const char* const* argv)
{
  Options options;
  return runWithOptions (
      tool.program,
      tool.summary,
      [&] (CLI::App& app) { tool.declare (app, options); },
      [&] { return tool.run (options); },
      tool.needs_arguments,
      argc,
      argv);
}

} // namespace pcl_msf::tool
