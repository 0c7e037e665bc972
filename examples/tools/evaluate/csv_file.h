// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/shard.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief What a kind of results file looks like: a line that names the kind, lines "#
 * NAME value" about the run, the names of the columns, a line per row. */
struct CsvLayout {
  std::string format;               ///< the first line
  std::vector<std::string> notes;   ///< names of the lines about the run
  std::vector<std::string> columns; ///< names
  bool quoted; ///< fields are quoted where need be (RFC 4180); else none is, and the
               ///< first may hold commas
  bool grows;  ///< row by row: a last line without an end is half of one, and dropped
};

/** \brief All before the rows. \param values of the notes, in their order */
std::string
headText (const CsvLayout& layout, const std::vector<std::string>& values);

/** \brief A number in as few digits as say exactly it. */
std::string
shortestText (double value);

/** \brief A row with its end. */
std::string
lineText (const CsvLayout& layout, const std::vector<std::string>& fields);

/** \brief The fields of a line without its end. \throws InvalidInput unless there are
 * as many as columns */
std::vector<std::string>
splitLine (const CsvLayout& layout, const std::string& line);

/** \brief Does a file begin as this kind does? */
bool
isCsv (const std::string& path, const CsvLayout& layout);

/** \brief Reads the lines of a file and tells where it is. Lines may end as on Windows.
 */
class CsvReader {
public:
  /** \brief Reads all before the rows. \throws IoError naming file and line */
  CsvReader (const std::string& path, const CsvLayout& layout);

  /** \brief The value of a note. */
  const std::string&
  note (const std::string& name) const;
  /** \brief The note "shard". \throws IoError unless it is one of 1/N to N/N */
  Shard
  shard () const;
  /** \brief A note that is a number from 0 on. \throws IoError */
  std::size_t
  count (const std::string& name) const;

  /** \brief False at the end. */
  bool
  next (std::string& line);

  /** \brief Of the line that was read last. \throws IoError always */
  [[noreturn]] void
  fail (const std::string& problem) const;

private:
  std::string path_;
  const CsvLayout& layout_;
  std::string text_;
  std::size_t at_{0};
  int line_{0};
  std::vector<std::string> values_; ///< of the notes
};

} // namespace pcl_msf::tool
