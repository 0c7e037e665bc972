// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <algorithm>
#include <string>

namespace pcl_msf::tool {

/** \brief A text as one field of one line: ends of lines and tabs become blanks. Names
 * of files may hold them. */
inline std::string
oneLine (std::string text)
{
  std::replace_if (
      text.begin(),
      text.end(),
      [] (char c) { return c == '\n' || c == '\r' || c == '\t'; },
      ' ');
  return text;
}

} // namespace pcl_msf::tool
