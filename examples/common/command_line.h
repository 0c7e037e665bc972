// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief A command line that cannot be understood; what() is one line that names the
 * option. */
class CommandLineError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief One option: its name with the dashes, what follows it (empty for a switch),
 * help with the default, and a setter that refuses what does not parse. */
struct CommandOption {
  std::string name;
  std::string argument;
  std::string help;
  std::function<bool (const std::string&)> set;
};

/** \brief A tool's options and the help about them. */
struct CommandLine {
  std::string summary;
  std::vector<std::string> syntax;
  std::vector<CommandOption> options;
  std::function<void (const std::string&)> take_word; ///< what is no option

  /** \brief Reads "--name value" and "--name=value" and words. \throws
   * CommandLineError */
  void
  read (int argc, const char* const* argv) const;

  /** \brief Prints summary, syntax and options on stdout. */
  void
  printHelp () const;
};

} // namespace pcl_msf::tool
