// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "csv.h"
#include "options.h"

namespace pcl_msf::tool {

/** \brief Runs all methods on all pairs of the shard that the CSV does not hold yet,
 * writes each finished pair to it at once, and all of them in order at the end.
 * \throws what readers and writers throw; UsageError when the CSV is of another run */
ResultFile
evaluateAll (const EvaluateOptions& options);

} // namespace pcl_msf::tool
