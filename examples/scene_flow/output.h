// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "pipeline.h"

#include <string>

namespace pcl_msf::tool {

/** \brief Makes the folder, and its parents. \throws IoError */
void
makeFolder (const std::string& path);

/** \brief Writes all files of the result, report.json last; notes the time that took in
 * the outcome. \throws IoError, Interrupted */
void
writeOutcome (Outcome& outcome, const Options& options);

} // namespace pcl_msf::tool
