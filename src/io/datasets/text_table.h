// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/rigid_pose.h>

#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief Lines of words parted by white space, as most data sets list things. Lines
 * that are empty or begin with # are left out. */
class TextTable {
public:
  /** \param header_lines lines at the start to leave out, whatever they hold
   * \throws IoError when there is no such file, or it has more than 64 MB */
  explicit TextTable (const std::string& path, int header_lines = 0);

  std::size_t
  rows () const
  {
    return rows_.size();
  }

  /** \brief Number of words of a row. */
  std::size_t
  columns (std::size_t row) const
  {
    return rows_.at (row).words.size();
  }

  /** \brief Each of these throws IoError "path: line N, field: problem" when the word
   * is missing or of another kind. */
  const std::string&
  word (std::size_t row, std::size_t column, const std::string& field) const;

  /** \brief A finite number. */
  double
  number (std::size_t row, std::size_t column, const std::string& field) const;

  int
  wholeNumber (std::size_t row, std::size_t column, const std::string& field) const;

  /** \brief A rigid motion from the upper three rows of a 4x4 matrix, row by row, from
   * a column on. */
  RigidPose
  pose (std::size_t row, std::size_t column) const;

  [[noreturn]] void
  fail (std::size_t row, const std::string& field, const std::string& problem) const;

private:
  struct Row {
    int line;
    std::vector<std::string> words;
  };
  std::string path_;
  std::vector<Row> rows_;
};

} // namespace pcl_msf::io
