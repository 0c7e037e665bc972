// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "options.h"
#include "pair_table.h"

#include <cstddef>

namespace pcl_msf::tool {

/** \brief What came of a run. */
struct RunOutcome {
  ResultFile results;
  std::size_t failed{0}; ///< pairs that could not be done; each was told on stderr
};

/** \brief Runs all methods on all pairs of the shard that the CSV does not hold yet,
 * writes each finished pair to it at once, and all of them in order at the end.
 * \throws what readers and writers throw; UsageError when the CSV is of another run;
 * Interrupted after a signal, when the pairs at work are finished and written */
RunOutcome
evaluateAll (const EvaluateOptions& options);

} // namespace pcl_msf::tool
