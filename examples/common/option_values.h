// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/number_text.h"
#include <pcl_msf/pinhole_camera.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl_msf::tool {

using Setter = std::function<bool (const std::string&)>;

/** \brief The whole text as one finite number, independent of the locale. */
template <typename Number>
bool
parse (const std::string& text, Number& value)
{
  Number parsed{};
  if (!parseNumber (text, parsed))
    return false;
  if constexpr (std::is_floating_point_v<Number>)
    if (!std::isfinite (parsed))
      return false;
  value = parsed;
  return true;
}

template <typename Number>
Setter
number (Number& value)
{
  return [&value] (const std::string& text) { return parse (text, value); };
}

/** \brief Any text but an empty one. */
inline Setter
text (std::string& value)
{
  return [&value] (const std::string& given) {
    value = given;
    return !given.empty();
  };
}

/** \brief For a switch. */
inline Setter
flag (bool& value)
{
  return [&value] (const std::string&) { return value = true; };
}

/** \brief "0" or "1". */
inline Setter
boolean (bool& value)
{
  return [&value] (const std::string& text) {
    value = text == "1";
    return text == "0" || text == "1";
  };
}

/** \brief One of several words. */
template <typename Enum>
Setter
choice (Enum& value, const std::vector<std::pair<std::string, Enum>>& words)
{
  return [&value, words] (const std::string& text) {
    for (const auto& [word, meaning] : words)
      if (word == text) {
        value = meaning;
        return true;
      }
    return false;
  };
}

/** \brief Numbers parted by one character, all of them. */
template <typename Number, std::size_t N>
bool
parseList (const std::string& text, char separator, Number (&numbers)[N])
{
  std::size_t begin = 0;
  for (Number& value : numbers) {
    if (begin > text.size())
      return false;
    const std::size_t end = std::min (text.find (separator, begin), text.size());
    if (!parse (text.substr (begin, end - begin), value))
      return false;
    begin = end + 1;
  }
  return begin == text.size() + 1;
}

/** \brief "FX,FY,CX,CY". */
inline bool
parseCamera (const std::string& text, PinholeCamera& camera)
{
  double numbers[4];
  if (!parseList (text, ',', numbers))
    return false;
  camera.fx = numbers[0];
  camera.fy = numbers[1];
  camera.cx = numbers[2];
  camera.cy = numbers[3];
  return true;
}

/** \brief A camera that need not be given. */
inline Setter
camera (std::optional<PinholeCamera>& value)
{
  return [&value] (const std::string& text) {
    return parseCamera (text, value.emplace());
  };
}

/** \brief A number that need not be given, above 0. */
inline Setter
positive (std::optional<double>& value)
{
  return [&value] (const std::string& text) {
    return parse (text, value.emplace()) && *value > 0.0;
  };
}

/** \brief A number above zero. */
inline Setter
positive (double& value)
{
  return
      [&value] (const std::string& text) { return parse (text, value) && value > 0.0; };
}

} // namespace pcl_msf::tool
