// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/pinhole_camera.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
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
  const char* end = text.data() + text.size();
  const auto result = std::from_chars (text.data(), end, parsed);
  if (text.empty() || result.ec != std::errc() || result.ptr != end)
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

/** \brief "FX,FY,CX,CY". */
inline bool
parseCamera (const std::string& text, PinholeCamera& camera)
{
  std::size_t begin = 0;
  double* const fields[] = {&camera.fx, &camera.fy, &camera.cx, &camera.cy};
  for (double* field : fields) {
    if (begin > text.size())
      return false;
    const std::size_t end = std::min (text.find (',', begin), text.size());
    if (!parse (text.substr (begin, end - begin), *field))
      return false;
    begin = end + 1;
  }
  return begin == text.size() + 1;
}

} // namespace pcl_msf::tool
