// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "pipeline.h"

namespace pcl_msf::tool {

/** \brief Writes all files of the result, report.json last; notes the time that took in
 * the outcome. \throws IoError, Interrupted */
void
writeOutcome (Outcome& outcome, const Options& options);

} // namespace pcl_msf::tool
