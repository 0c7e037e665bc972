// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <charconv>
#include <string_view>
#include <system_error>

namespace pcl_msf::io {

/** \brief Reads a whole text as one number, independent of the locale.
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

} // namespace pcl_msf::io
