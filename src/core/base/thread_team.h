// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
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
 * not. Where the caller is stopped, or waits for a helper that is (as other programs
 * want the processors), it works alone for a while: beside busy programs, more threads
 * then cost little more than one. Of the threads that a loop may have, those that do
 * something else meanwhile do not help.
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

  using Clock = std::chrono::steady_clock;

  /** \brief What a loop that threads shared has taken. */
  struct LoopTimes {
    Clock::duration elapsed;        ///< for the caller's part
    Clock::duration stopped;        ///< of that, in which it did not run
    Clock::duration wait;           ///< for helpers, afterwards
    Clock::duration helper_stopped; ///< of its part: the helper's that was so longest
  };

  /** \brief How long to work alone after a loop: zero unless other programs took much
   * of its time. To wait for a helper that had more to do is no sign of that. */
  static Clock::duration
  timeAlone (const LoopTimes& times);

  /** \brief Has a helper do a job while the caller goes on; meanwhile () is how to use
   * it. A helper that is awake, or slept on a processor of its own, is there at once; a
   * new thread may begin on the caller's, and stay there for long. \return false when
   * there is no helper to be had: nobody does the job then */
  bool
  doAside (std::function<void()> job);

  /** \brief How many helpers do such jobs now, or are about to. */
  int
  elsewhere () const
  {
    return elsewhere_;
  }

private:
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
  workAside ();
  void
  help ();
  bool
  enter ();
  void
  leave ();
  bool
  takeJob ();
  bool
  waitForWork (unsigned& seen);
  void
  work ();

  std::vector<std::thread> helpers_;
  Loop loop_;
  std::atomic<int> next_{0};       ///< first index that nobody has taken
  std::atomic<unsigned> gate_{0};  ///< places left (upper half), helpers inside (lower)
  std::atomic<unsigned> round_{0}; ///< of loops
  std::mutex mutex_;               ///< for sleeping, error_ and jobs_
  std::condition_variable begun_;
  std::condition_variable done_;
  std::atomic<int> sleeping_{0};
  std::atomic<Clock::rep> helper_stopped_{0}; ///< in this round; the longest of all
  std::atomic<bool> caller_sleeps_{false};
  std::atomic<bool> ended_{false};
  std::exception_ptr error_;
  std::deque<std::function<void()>> jobs_; ///< that nobody has begun
  std::atomic<int> waiting_jobs_{0};
  std::atomic<int> elsewhere_{0};   ///< jobs that are not done
  Clock::time_point alone_until_{}; ///< the caller works alone until then
};

} // namespace pcl_msf
