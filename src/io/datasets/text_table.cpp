// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/text_table.h"

#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include "io/base/rotation_check.h"
#include <pcl_msf/errors.h>

#include <cmath>
#include <sstream>

namespace pcl_msf::io {

namespace {

constexpr std::uint64_t kLargest = std::uint64_t{1} << 26;

} // namespace

TextTable::TextTable (const std::string& path, int header_lines) : path_ (path)
{
  InputFile file (path);
  std::istringstream lines (file.text (kLargest));
  std::string line;
  for (int number = 1; std::getline (lines, line); ++number) {
    if (number <= header_lines)
      continue;
    Row row{number, {}};
    std::istringstream words (line);
    for (std::string word; words >> word;)
      row.words.push_back (word);
    if (!row.words.empty() && row.words[0][0] != '#')
      rows_.push_back (std::move (row));
  }
}

const std::string&
TextTable::word (std::size_t row, std::size_t column, const std::string& field) const
{
  if (column >= rows_.at (row).words.size())
    fail (row, field, "missing; the line is cut short");
  return rows_[row].words[column];
}

double
TextTable::number (std::size_t row, std::size_t column, const std::string& field) const
{
  double value = 0.0;
  const std::string& text = word (row, column, field);
  if (!parseNumber (text, value) || !std::isfinite (value))
    fail (row,
          field,
          "'" + text.substr (0, 32) +
              "' is no finite number; numbers have a decimal point and blanks between "
              "them");
  return value;
}

int
TextTable::wholeNumber (std::size_t row,
                        std::size_t column,
                        const std::string& field) const
{
  int value = 0;
  const std::string& text = word (row, column, field);
  if (!parseNumber (text, value))
    fail (row,
          field,
          "'" + text.substr (0, 32) +
              "' is no whole number; the file is damaged or of another format");
  return value;
}

RigidPose
TextTable::pose (std::size_t row, std::size_t column) const
{
  Eigen::Matrix<double, 3, 4> matrix;
  for (int i = 0; i < 12; ++i)
    matrix (i / 4, i % 4) = number (row,
                                    column + static_cast<std::size_t> (i),
                                    "matrix element " + std::to_string (i / 4 + 1) +
                                        "," + std::to_string (i % 4 + 1));
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  if (!isRotation (rotation))
    fail (
        row,
        "matrix",
        "no rigid motion, for its rotation is not orthonormal; the file is damaged or "
        "of another format");
  return RigidPose::fromMatrix (rotation, matrix.col (3));
}

void
TextTable::fail (std::size_t row,
                 const std::string& field,
                 const std::string& problem) const
{
  throw IoError (path_ + ": line " + std::to_string (rows_.at (row).line) + ", " +
                 field + ": " + problem);
}

} // namespace pcl_msf::io
