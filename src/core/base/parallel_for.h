// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/thread_team.h"
#include <pcl_msf/export.h>

#include <algorithm>
#include <atomic>

namespace pcl_msf {

/** \brief How many threads a setting means: itself, or a thread per processor that this
 * process may use for 0. */
PCL_MSF_EXPORT int
threadCount (unsigned wanted);

/** \brief Calls f (i) for each i in [0, n), on this thread and up to threads - 1
 * others.
 *
 * Which thread takes which `chunk` of indices is left to chance, so f must write only
 * to what belongs to i. With one thread, or from within such a loop, it is a plain loop
 * and nothing of the threads is touched. The first exception of f is thrown again here.
 */
template <typename F>
void
parallelFor (int threads, int n, int chunk, const F& f)
{
  const auto part = [&f] (int begin, int end) {
    for (int i = begin; i < end; ++i)
      f (i);
  };
  if (threads <= 1 || n <= chunk || ThreadTeam::busyHere())
    part (0, n);
  else
    ThreadTeam::ofThisThread().run (threads, n, chunk, part);
}

/** \brief The sum of f (i), whole numbers, over all i in [0, n): in parallel as above.
 */
template <typename F>
int
parallelSum (int threads, int n, int chunk, const F& f)
{
  std::atomic<int> sum{0};
  parallelFor (threads, n, chunk, [&] (int i) {
    if (const int value = f (i); value != 0)
      sum.fetch_add (value, std::memory_order_relaxed);
  });
  return sum;
}

} // namespace pcl_msf
