// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "cloud_run.h"
#include "common/shard.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief A method's answer to a case. */
struct CloudRow {
  std::string name;
  std::string method;
  CloudScore score;
  bool converged;
  double seconds;
  int number; ///< of the case, from 0
};

/** \brief Results on clouds without a grid. */
struct CloudTable {
  std::string settings; ///< what rows depend on; of others they are not comparable
  std::vector<std::string> methods;
  int cases{0}; ///< of all shards
  Shard shard;  ///< that the rows are of
  std::vector<CloudRow> rows;
};

/** \brief A CSV, after lines about the run that begin with #. */
std::string
csvText (const CloudTable& table);

/** \brief Is a file such a CSV? */
bool
isCloudCsv (const std::string& path);

/** \throws IoError naming the file and the line */
CloudTable
readCloudCsv (const std::string& path);

/** \brief Joins shards of one run; by case, then by method. \throws UsageError naming
 * the remedy for files of different runs, and for rows that come twice */
CloudTable
mergeClouds (const std::vector<std::string>& paths);

/** \brief Numbers of cases, from 1, that some method has no row of; empty = none. */
std::string
missingCases (const CloudTable& table);

/** \brief Version, settings, means per method and rows. */
std::string
jsonText (const CloudTable& table);

/** \brief The table that people read: all rows, then means over the cases that all
 * methods have answered. */
std::string
tablesText (const CloudTable& table);

} // namespace pcl_msf::tool
