// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <array>
#include <charconv>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

// Numbers as text and back, whatever locale the application has set: printf, strtod,
// std::to_string (double) and streams write and want a comma in half of the world.
namespace pcl_msf {

/** \brief Reads a whole text as one number.
 * \return false, and `value` untouched, for anything else */
template <typename Number>
bool
parseNumber (std::string_view text, Number& value)
{
  if (!text.empty() && text.front() == '+')
    text.remove_prefix (1);
  Number parsed{};
  const auto result = std::from_chars (text.data(), text.data() + text.size(), parsed);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size())
    return false;
  value = parsed;
  return true;
}

/** \brief Up to `digits` significant ones, as printf's %g. */
inline std::string
generalText (double value, int digits = 6)
{
  std::array<char, 64> text{};
  const auto end = std::to_chars (text.data(),
                                  text.data() + text.size(),
                                  value,
                                  std::chars_format::general,
                                  digits);
  return {text.data(), end.ptr};
}

/** \brief With `decimals` behind the point, as printf's %f. */
inline std::string
fixedText (double value, int decimals)
{
  std::array<char, 512> text{}; // the largest double has 309 digits
  const auto end = std::to_chars (text.data(),
                                  text.data() + text.size(),
                                  value,
                                  std::chars_format::fixed,
                                  decimals);
  return {text.data(), end.ptr};
}

/** \brief A stream for messages and files: the same text in every locale. */
class PlainStream : public std::ostringstream {
public:
  PlainStream() { imbue (std::locale::classic()); }
};

} // namespace pcl_msf
