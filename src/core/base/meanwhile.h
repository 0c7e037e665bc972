// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/thread_team.h"
#include "core/base/without_signals.h"

#include <atomic>
#include <future>
#include <memory>
#include <system_error>
#include <utility>

namespace pcl_msf {

/** \brief Counts one thread until the last copy ends. */
class Elsewhere {
public:
  explicit Elsewhere (std::shared_ptr<std::atomic<int>> count)
  {
    ++*count;
    present_ = std::shared_ptr<void> (nullptr, [count] (void*) { --*count; });
  }

private:
  std::shared_ptr<void> present_;
};

/** \brief Has another thread call f while the caller goes on; where the caller may not
 * have one, or gets none, it calls f itself when it asks for the result. Exceptions of
 * f come with the result. \param threads that the caller may use, itself included */
template <typename F>
auto
meanwhile (int threads, F f) -> std::future<decltype (f())>
{
  if (threads > 1 && !ThreadTeam::busyHere()) {
    const WithoutSignals quiet;
    Elsewhere counted (ThreadTeam::ofThisThread().elsewhere());
    try {
      return std::async (std::launch::async, [f, counted] () mutable {
        const Elsewhere until_done (std::move (counted));
        return f();
      });
    }
    catch (const std::system_error&) { // no more threads
    }
  }
  return std::async (std::launch::deferred, std::move (f));
}

} // namespace pcl_msf
