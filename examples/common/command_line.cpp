// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/command_line.h"

#include <pcl/console/print.h>

#include <cstdio>

namespace pcl_msf::tool {

namespace {

const Option&
findOption (const std::vector<OptionGroup>& groups, const std::string& name)
{
  for (const OptionGroup& group : groups)
    for (const Option& option : group.options)
      if (option.name == name || (name == "-h" && option.name == "--help"))
        return option;
  throw UsageError (name + ": no such option; --help lists them");
}

} // namespace

void
readCommandLine (int argc,
                 const char* const* argv,
                 const std::vector<OptionGroup>& groups,
                 const std::function<void (const std::string&)>& take_word)
{
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.rfind ("-", 0) != 0) {
      take_word (word);
      continue;
    }
    const std::size_t equals = word.find ('=');
    const std::string name = word.substr (0, equals);
    const Option& option = findOption (groups, name);
    std::string value =
        equals == std::string::npos ? std::string() : word.substr (equals + 1);
    if (!option.argument.empty() && equals == std::string::npos) {
      if (i + 1 >= argc)
        throw UsageError (name + ": needs a value, " + option.argument);
      value = argv[++i];
    }
    else if (option.argument.empty() && equals != std::string::npos)
      throw UsageError (name + ": takes no value");
    if (!option.set (value))
      throw UsageError (name + ": '" + value + "' is no " + option.argument + "; " +
                        option.help);
  }
}

void
printOptions (const std::vector<OptionGroup>& groups)
{
  using namespace pcl::console;
  for (const OptionGroup& group : groups) {
    print_info ("\n%s:\n", group.title.c_str());
    for (const Option& option : group.options) {
      print_value ("  %-22s %-12s", option.name.c_str(), option.argument.c_str());
      print_info (" %s\n", option.help.c_str());
    }
  }
}

void
CommandLine::read (int argc, const char* const* argv) const
{
  readCommandLine (argc, argv, {{{}, options}}, take_word);
}

void
CommandLine::printHelp() const
{
  std::printf ("%s\n\n", summary.c_str());
  for (std::size_t i = 0; i < syntax.size(); ++i)
    std::printf ("%s %s\n", i == 0 ? "Syntax:" : "    or:", syntax[i].c_str());
  std::printf ("\n");
  for (const Option& option : options)
    std::printf ("  %-16s %-14s %s\n",
                 option.name.c_str(),
                 option.argument.c_str(),
                 option.help.c_str());
}

} // namespace pcl_msf::tool
