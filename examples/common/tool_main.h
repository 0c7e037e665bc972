// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <functional>
#include <string>

namespace pcl_msf::tool {

/** \brief One line on stderr, "program: message", whatever the message holds. */
void
complain (const std::string& program, std::string message);

/** \brief Runs `work` and returns its exit status. What it throws becomes one line on
 * stderr and the status 1, that of the signal for Interrupted. OpenCV's own messages
 * would stand beside that line and are turned off. */
int
runTool (const std::string& program, const std::function<int()>& work);

/** \brief Turns off PCL's messages, too, and notes signals: the help is behind us. */
void
beginWork ();

/** \brief What a tool with `Options` is made of; Options::help asks for the help. */
template <typename Options>
struct Tool {
  const char* program;
  Options (*parse) (int argc, const char* const* argv);
  void (*print_help) (const char* program);
  int (*run) (const Options& options);
};

/** \brief The main() of a tool: help without arguments or when asked for, else its run.
 * Returns the exit status. */
template <typename Options>
int
toolMain (const Tool<Options>& tool, int argc, const char* const* argv)
{
  return runTool (tool.program, [&] {
    if (argc < 2) {
      tool.print_help (tool.program);
      return 1;
    }
    const Options options = tool.parse (argc, argv);
    if (options.help) {
      tool.print_help (tool.program);
      return 0;
    }
    beginWork();
    return tool.run (options);
  });
}

} // namespace pcl_msf::tool
