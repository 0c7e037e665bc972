// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief A Markdown table whose columns are aligned in the text, too. */
class TableText {
public:
  using Line = std::vector<std::string>;

  explicit TableText (Line head);

  /** \param line as many cells as the head */
  void
  add (Line line);

  bool
  empty () const
  {
    return lines_.size() == 1;
  }

  std::string
  text () const;

private:
  std::vector<Line> lines_;
};

/** \brief A number; "-" when it is not finite. */
std::string
cell (double value, int decimals);

} // namespace pcl_msf::tool
