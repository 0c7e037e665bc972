// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/shard.h"
#include "score.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief A result file of pairs of frames, see CsvLayout: a line per method and pair;
 * an empty field is unknown. */
struct ResultFile {
  std::string version;  ///< of the program
  std::string settings; ///< see EvaluateOptions::settings
  Shard shard;
  std::size_t pairs{0}; ///< of the whole run, all shards together
  std::vector<Row> rows;
};

/** \brief Comments and names of columns. */
std::string
headText (const ResultFile& file);

/** \brief A row as a line, with its end. */
std::string
rowText (const Row& row);

/** \brief Reads a row. \throws InvalidInput naming the field */
Row
parseRow (const std::string& line);

/** \brief Reads a result file; a last line without an end is dropped, as a run that
 * was killed leaves it. \throws IoError naming file, line and field */
ResultFile
readResults (const std::string& path);

/** \brief Writes a result file, whole or not at all. \throws IoError */
void
writeResults (const std::string& path, const ResultFile& file);

} // namespace pcl_msf::tool
