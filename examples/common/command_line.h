// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/option_values.h"

#include <functional>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace pcl_msf::tool {

/** \brief A command line that cannot be understood; what() is one line that names the
 * option. */
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief Words and what they mean. */
template <typename Value>
using Words = std::vector<std::pair<std::string, Value>>;

/** \brief Adds an option, or a positional argument when `name` has no dashes.
 *
 * Numbers are read without a locale, therefore by `take` and not by CLI11.
 * \param type what the value is, for the help \param preset the default, for the help;
 * empty = none is shown \param take reads the value; false when it does not parse. Of
 * an option that is given again the last value counts. */
CLI::Option*
addOption (CLI::App& app,
           const std::string& name,
           const std::string& type,
           const std::string& help,
           std::function<bool (const std::string&)> take,
           const std::string& preset = {});

/** \brief An option for a list "A,B,..." that `take` reads; lists of an option that is
 * given again are joined. */
CLI::Option*
addList (CLI::App& app,
         const std::string& name,
         const std::string& help,
         std::function<bool (const std::string&)> take,
         const std::string& preset);

/** \brief An option for any text but an empty one. */
CLI::Option*
addText (CLI::App& app,
         const std::string& name,
         const std::string& type,
         const std::string& help,
         std::string& value);

/** \brief An option that may be given again, or arguments without a name. */
CLI::Option*
addTexts (CLI::App& app,
          const std::string& name,
          const std::string& type,
          const std::string& help,
          std::vector<std::string>& values);

/** \brief A switch without a value. */
CLI::Option*
addFlag (CLI::App& app, const std::string& name, const std::string& help, bool& value);

/** \brief A switch with the value 0 or 1. */
CLI::Option*
addSwitch (CLI::App& app,
           const std::string& name,
           const std::string& help,
           bool& value);

/** \brief A number as text, as the help shows it. */
template <typename Number>
std::string
presetText (Number value)
{
  std::ostringstream text;
  text.imbue (std::locale::classic());
  text << value;
  return text.str();
}

/** \brief An option for a number; the help shows its present value. */
template <typename Number>
CLI::Option*
addNumber (CLI::App& app,
           const std::string& name,
           const std::string& type,
           const std::string& help,
           Number& value)
{
  return addOption (
      app,
      name,
      type,
      help,
      [&value] (const std::string& text) { return parse (text, value); },
      presetText (value));
}

/** \brief An option for a number that need not be there. */
template <typename Number>
CLI::Option*
addNumber (CLI::App& app,
           const std::string& name,
           const std::string& type,
           const std::string& help,
           std::optional<Number>& value)
{
  return addOption (app, name, type, help, [&value] (const std::string& text) {
    return parse (text, value.emplace());
  });
}

/** \brief An option for one of several words; the help shows that of the present value.
 */
template <typename Enum>
CLI::Option*
addWord (CLI::App& app,
         const std::string& name,
         const std::string& help,
         Enum& value,
         const Words<Enum>& words)
{
  return addOption (
      app,
      name,
      wordList (words, "|"),
      help,
      [&value, words] (const std::string& text) { return choose (text, words, value); },
      wordOf (value, words));
}

/** \brief An option for some of several words, joined by commas; see addList. */
template <typename Enum>
CLI::Option*
addWords (CLI::App& app,
          const std::string& name,
          const std::string& help,
          std::vector<Enum>& values,
          const Words<Enum>& words)
{
  std::string preset;
  for (const Enum& value : values)
    preset += (preset.empty() ? "" : ",") + wordOf (value, words);
  const auto take = [&values, words] (const std::string& text) {
    values.clear();
    for (const std::string& word : splitAtCommas (text))
      if (!choose (word, words, values.emplace_back()))
        return false;
    return !values.empty();
  };
  return addList (app, name, help, take, preset);
}

/** \brief The options that follow stand under this headline in the help. */
void
beginGroup (CLI::App& app, const std::string& title);

/** \brief Reads "--name value", "--name=value", -h and the arguments without a name.
 * \return false when help, or another thing that ends the tool, was requested, which is
 * on stdout then \throws UsageError */
bool
readCommandLine (CLI::App& app, const std::vector<std::string>& words);

} // namespace pcl_msf::tool
