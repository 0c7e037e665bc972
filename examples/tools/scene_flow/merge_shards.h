// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/shard.h"

#include <string>

namespace pcl_msf::tool {

/** \brief Where a shard of a run writes, inside the run's folder. */
std::string
folderOfShard (const std::string& output, const Shard& shard);

/** \brief Makes of the shards' folders what one run would have written, and removes
 * them. \return have all windows converged? \throws UsageError when windows are
 * missing, naming the shards, or a file is in the way; then nothing has changed */
bool
mergeShards (const std::string& output, const char* program);

} // namespace pcl_msf::tool
