// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/command_line.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <cstdio>

namespace pcl_msf::tool {

namespace {

/** What CLI11 refuses, in the words of the tools: the option, then the remedy. */
std::string
refusal (const CLI::App& app, const CLI::ParseError& error)
{
  const std::string text = error.what();
  const std::string name = text.substr (0, text.find (':'));
  if (dynamic_cast<const CLI::ArgumentMismatch*> (&error) != nullptr)
    return name + ": needs a value; --help lists the options";
  if (dynamic_cast<const CLI::ExtrasError*> (&error) != nullptr) {
    const std::string word = app.remaining().front();
    return word.rfind ('-', 0) == 0
               ? word.substr (0, word.find ('=')) +
                     ": no such option; --help lists them"
               : "'" + word + "': one word too many and not an option; options have --";
  }
  if (dynamic_cast<const CLI::ConversionError*> (&error) != nullptr)
    return text.substr (text.find ("--")) +
           ": no value of this option; --help lists it";
  if (dynamic_cast<const CLI::RequiredError*> (&error) != nullptr)
    return text + "; --help shows the syntax";
  return text;
}

} // namespace

CLI::Option*
addOption (CLI::App& app,
           const std::string& name,
           const std::string& type,
           const std::string& help,
           std::function<bool (const std::string&)> take,
           const std::string& preset)
{
  const auto read = [name, type, help, take] (const CLI::results_t& values) {
    if (!take (values.back()))
      throw UsageError (name + ": '" + values.back() + "' is no " + type + "; " + help);
    return true;
  };
  CLI::Option* option = app.add_option (name, read, help);
  return option->type_name (type)->default_str (preset)->multi_option_policy (
      CLI::MultiOptionPolicy::TakeLast);
}

CLI::Option*
addList (CLI::App& app,
         const std::string& name,
         const std::string& help,
         std::function<bool (const std::string&)> take,
         const std::string& preset)
{
  const std::string type = "A,B,...";
  const auto read = [name, type, help, take] (const CLI::results_t& given) {
    std::string all;
    for (const std::string& list : given)
      all += (all.empty() ? "" : ",") + list;
    if (!take (all))
      throw UsageError (name + ": '" + all + "' is no " + type + "; " + help);
    return true;
  };
  return app.add_option (name, read, help)
      ->type_name (type)
      ->default_str (preset)
      ->expected (-1)
      ->allow_extra_args (false)
      ->multi_option_policy (CLI::MultiOptionPolicy::TakeAll);
}

CLI::Option*
addText (CLI::App& app,
         const std::string& name,
         const std::string& type,
         const std::string& help,
         std::string& value)
{
  const auto take = [&value] (const std::string& text) {
    value = text;
    return !text.empty();
  };
  return addOption (app, name, type, help, take, value);
}

CLI::Option*
addTexts (CLI::App& app,
          const std::string& name,
          const std::string& type,
          const std::string& help,
          std::vector<std::string>& values)
{
  const auto read = [name, &values] (const CLI::results_t& given) {
    values = given;
    if (std::find (given.begin(), given.end(), "") != given.end())
      throw UsageError (name + ": '' is no name; give one");
    return true;
  };
  const bool positional = name.rfind ("--", 0) != 0;
  return app.add_option (name, read, help)
      ->type_name (type)
      ->expected (-1)
      ->allow_extra_args (positional)
      ->multi_option_policy (CLI::MultiOptionPolicy::TakeAll);
}

CLI::Option*
addFlag (CLI::App& app, const std::string& name, const std::string& help, bool& value)
{
  return app.add_flag (name, value, help);
}

CLI::Option*
addSwitch (CLI::App& app, const std::string& name, const std::string& help, bool& value)
{
  return addWord<bool> (app, name, help, value, {{"0", false}, {"1", true}});
}

void
beginGroup (CLI::App& app, const std::string& title)
{
  app.option_defaults()->group (title);
}

bool
readCommandLine (CLI::App& app, const std::vector<std::string>& words)
{
  for (const std::string& word : words) // CLI11 would take the next word in its place
    if (word.rfind ("--", 0) == 0 && word.back() == '=')
      throw UsageError (word.substr (0, word.size() - 1) +
                        ": needs a value; --help lists the options");
  try {
    app.parse (std::vector<std::string> (words.rbegin(), words.rend()));
  }
  catch (const CLI::CallForHelp&) {
    std::fputs (app.help().c_str(), stdout);
    return false;
  }
  catch (const CLI::Success&) {
    return false;
  }
  catch (const CLI::ParseError& error) {
    throw UsageError (refusal (app, error));
  }
  return true;
}

} // namespace pcl_msf::tool
