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
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief One option of a command line. */
struct Option {
  std::string name;     ///< with the dashes
  std::string argument; ///< what follows it; empty for a switch
  std::string help;     ///< with the default

  /** \brief Takes the value; false when it does not parse. */
  std::function<bool (const std::string&)> set;
};

/** \brief A headline and the options below it. */
struct OptionGroup {
  std::string title;
  std::vector<Option> options;
};

/** \brief Reads "--name value", "--name=value" and, as --help, "-h"; words without a
 * dash in front go to `take_word`. \throws UsageError */
void
readCommandLine (int argc,
                 const char* const* argv,
                 const std::vector<OptionGroup>& groups,
                 const std::function<void (const std::string&)>& take_word);

/** \brief Prints headlines and options on stdout, by PCL's console. */
void
printOptions (const std::vector<OptionGroup>& groups);

/** \brief A tool's options and the help about them, without headlines. */
struct CommandLine {
  std::string summary;
  std::vector<std::string> syntax;
  std::vector<Option> options;
  std::function<void (const std::string&)> take_word; ///< what is no option

  /** \brief As readCommandLine(). \throws UsageError */
  void
  read (int argc, const char* const* argv) const;

  /** \brief Prints summary, syntax and options on stdout. */
  void
  printHelp () const;
};

} // namespace pcl_msf::tool
