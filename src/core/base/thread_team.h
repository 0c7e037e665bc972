// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace pcl_msf {

/** \brief A calling thread and its helpers, which sleep between the loops that they
 * share; parallelFor () is how to use it.
 *
 * Each thread that runs parallel loops has a team of its own: two registrations in two
 * threads share nothing. Helpers are started when they are first needed, end with the
 * thread that they help, and get no signals. A process that was forked has none of its
 * parent's threads: the first loop in it starts new ones.
 *
 * A helper joins a loop if it wakes in time; the caller does not wait for those that do
 * not. Where the caller is stopped, or waits long for a helper that is (as other
 * programs want the processors), it works alone for a while: beside busy programs, more
 * threads then cost little more than one.
 */
class PCL_MSF_EXPORT ThreadTeam {
public:
  /** \brief The calling thread's. */
  static ThreadTeam&
  ofThisThread ();

  /** \brief Does this thread work in a team's loop just now? */
  static bool
  busyHere ();

  ThreadTeam() = default;
  ~ThreadTeam();
  ThreadTeam (const ThreadTeam&) = delete;
  ThreadTeam&
  operator= (const ThreadTeam&) = delete;

  /** \brief Has parts of [0, n) done: part (begin, end) for each `chunk` of it. */
  template <typename Part>
  void
  run (int threads, int n, int chunk, const Part& part)
  {
    run (Loop{[] (const void* p, int begin, int end) {
                (*static_cast<const Part*> (p)) (begin, end);
              },
              &part,
              n,
              chunk},
         threads);
  }

  /** \brief Does the caller work alone for now, beside busy programs? */
  bool
  isHeldUp () const;

private:
  using Clock = std::chrono::steady_clock;

  struct Loop {
    void (*part) (const void*, int, int){nullptr};
    const void* context{nullptr};
    int n{0};
    int chunk{1};
  };

  void
  run (const Loop& loop, int threads);
  void
  hire (int helpers);
  void
  open (int helpers);
  void
  close ();
  void
  judge (Clock::duration work, Clock::duration stopped, Clock::duration wait);
  void
  help ();
  bool
  enter ();
  void
  leave ();
  bool
  waitForRound (unsigned& seen);
  void
  work ();

  std::vector<std::thread> helpers_;
  Loop loop_;
  std::atomic<int> next_{0};       ///< first index that nobody has taken
  std::atomic<unsigned> gate_{0};  ///< places left (upper half), helpers inside (lower)
  std::atomic<unsigned> round_{0}; ///< of loops
  std::mutex mutex_;               ///< for sleeping, and error_
  std::condition_variable begun_;
  std::condition_variable done_;
  std::atomic<int> sleeping_{0};
  std::atomic<bool> caller_sleeps_{false};
  std::atomic<bool> ended_{false};
  std::exception_ptr error_;
  Clock::time_point alone_until_{}; ///< the caller works alone until then
};

} // namespace pcl_msf
