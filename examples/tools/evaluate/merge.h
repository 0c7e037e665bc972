// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "pair_table.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Shards joined to the file that one machine would have written. */
struct Merged {
  ResultFile results;
  std::vector<std::string> missing; ///< one text per thing that is not there
};

/** \brief Joins the files of shards. What is missing does not keep the rest from being
 * joined: the result, given as --csv to the run without --shard, does the missing
 * pairs. \throws UsageError for files of different runs, and for pairs that come twice;
 * IoError for a file that is damaged */
Merged
mergeResults (const std::vector<std::string>& paths);

} // namespace pcl_msf::tool
