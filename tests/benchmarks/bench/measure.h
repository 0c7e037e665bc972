// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/methods/method.h"

#include <string>
#include <vector>

namespace pcl_msf::benchmarks {

/** \brief What to run. */
struct MeasureOptions {
  std::vector<std::string> methods{"msf", "rigid", "dis_medium", "tvl1", "gicp"};
  std::vector<unsigned> threads{1, 2};
  int repetitions{9};
  double most_seconds{20.0}; ///< of one method with one number of threads; one run at
                             ///< least
};

/** \brief A method with a number of threads. */
struct Measured {
  std::string method;
  unsigned threads;
  int runs;
  tool::StageSeconds seconds; ///< medians
  double megabytes; ///< that a run with one thread adds at its peak; NaN = unknown
};

/** \brief Runs all methods in turn, again and again, so that what else the machine does
 * hits all of them. Methods that need what the pair lacks are left out. \throws
 * UsageError for a method that does not exist */
std::vector<Measured>
measure (const tool::PairData& pair, const MeasureOptions& options);

} // namespace pcl_msf::benchmarks
