// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include "common/option_values.h"

#include <locale>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace pcl_msf::tool {

// Options whose help tells the default that the program has: it is read from the value.

/** \brief Help with the default, "... [0.5]", which is the value's at that time. */
template <typename T>
std::string
withDefault (const std::string& help, const T& value)
{
  std::ostringstream text;
  text.imbue (std::locale::classic());
  text << help << (help.empty() ? "[" : " [") << value << "]";
  return text.str();
}

/** \brief An option for a number. */
template <typename Number>
Option
numeric (const std::string& name,
         const std::string& argument,
         const std::string& help,
         Number& value)
{
  return {name, argument, withDefault (help, value), number (value)};
}

/** \brief An option for 0 or 1. */
inline Option
switchable (const std::string& name, const std::string& help, bool& value)
{
  return {name, "0|1", withDefault (help, value), boolean (value)};
}

/** \brief One of several words, listed in the help with the default's.
 * \param help behind the list */
template <typename Enum>
Option
oneOf (const std::string& name,
       Enum& value,
       const std::vector<std::pair<std::string, Enum>>& words,
       const std::string& help = {})
{
  std::string list;
  std::string preset;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool last = i + 1 == words.size();
    list += (i == 0 ? "" : last ? " or " : ", ") + words[i].first;
    if (words[i].second == value)
      preset = words[i].first;
  }
  return {name, "WORD", withDefault (list + help, preset), choice (value, words)};
}

} // namespace pcl_msf::tool
