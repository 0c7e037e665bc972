// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/table_text.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_msf::tool {

TableText::TableText (Line head) : lines_ (1, std::move (head)) {}

void
TableText::add (Line line)
{
  lines_.push_back (std::move (line));
}

std::string
TableText::text() const
{
  std::vector<std::size_t> widths (lines_[0].size(), 3);
  for (const Line& line : lines_)
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max (widths[i], line[i].size());
  std::string result, rule = "|";
  for (std::size_t i = 0; i < widths.size(); ++i)
    rule += i == 0 ? std::string (widths[i] + 2, '-') + "|"
                   : std::string (widths[i] + 1, '-') + ":|";
  for (const Line& line : lines_) {
    result += "|";
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string fill (widths[i] - line[i].size(), ' ');
      result += " " + (i == 0 ? line[i] + fill : fill + line[i]) + " |";
    }
    result += "\n";
    if (&line == &lines_.front())
      result += rule + "\n";
  }
  return result;
}

std::string
cell (double value, int decimals)
{
  if (!std::isfinite (value))
    return "-";
  return fixedText (value, decimals);
}

} // namespace pcl_msf::tool
