// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/number_text.h"
#include <pcl_msf/lens_distortion.h>
#include <pcl_msf/pinhole_camera.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl_msf::tool {

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

/** \brief The words, joined. */
template <typename Value>
std::string
wordList (const std::vector<std::pair<std::string, Value>>& words,
          const std::string& separator)
{
  std::string list;
  for (const auto& word : words)
    list += (list.empty() ? "" : separator) + word.first;
  return list;
}

/** \brief The word for a value; empty when there is none. */
template <typename Value>
std::string
wordOf (const Value& value, const std::vector<std::pair<std::string, Value>>& words)
{
  for (const auto& [word, meaning] : words)
    if (meaning == value)
      return word;
  return {};
}

/** \brief One of several words; false when the text is none of them. */
template <typename Value>
bool
choose (const std::string& text,
        const std::vector<std::pair<std::string, Value>>& words,
        Value& value)
{
  for (const auto& [word, meaning] : words)
    if (word == text) {
      value = meaning;
      return true;
    }
  return false;
}

/** \brief "A,B,..." */
inline std::vector<std::string>
splitAtCommas (const std::string& text)
{
  std::vector<std::string> words;
  std::istringstream stream (text);
  for (std::string word; std::getline (stream, word, ',');)
    words.push_back (word);
  return words;
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

/** \brief "K1,K2,P1,P2" or "K1,K2,P1,P2,K3", OpenCV's order. */
inline bool
parseDistortion (const std::string& text, LensDistortion& lens)
{
  double numbers[5] = {};
  double four[4];
  if (parseList (text, ',', four))
    std::copy (four, four + 4, numbers);
  else if (!parseList (text, ',', numbers))
    return false;
  lens = {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
  return true;
}

} // namespace pcl_msf::tool
