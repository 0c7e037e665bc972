// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/opencv_threads.h"

#include <opencv2/core/utility.hpp>

#include "core/base/thread_team.h"
#include <pthread.h>

#include <condition_variable>
#include <exception>
#include <mutex>

namespace pcl_msf {

namespace {

/** Threads that share one loop of OpenCV, that of the first; it stays in it until the
 * last has left. Those that come when all others have take the next one. */
class SharedLoop {
public:
  /** \brief The one of this process; a forked process has a new one, as the threads
   * that were within its parent's are not in it. */
  static SharedLoop&
  ofThisProcess ()
  {
    static SharedLoop* present = new SharedLoop;
    [[maybe_unused]] static const int registered =
        pthread_atfork (nullptr, nullptr, [] {
          present = new SharedLoop;
          forked = true;
        });
    return *present;
  }

  /** \brief Was this process forked from one that had used the above? OpenCV's threads
   * are not in it then. */
  static inline bool forked{false};

  void
  run (const std::function<void()>& f)
  {
    if (join())
      f();
    else
      cv::parallel_for_ ({0, 1}, [&] (const cv::Range&) {
        become (State::Held);
        f();
        waitForOthers();
      });
    leave();
  }

private:
  enum class State { Free, Entering, Held, Leaving };

  /** False: this thread is the first and has to enter the loop. */
  bool
  join ()
  {
    std::unique_lock<std::mutex> lock (mutex_);
    changed_.wait (lock, [this] {
      return state_ == State::Free || state_ == State::Held || keptOpen();
    });
    ++threads_;
    if (state_ != State::Free)
      return true;
    state_ = State::Entering;
    return false;
  }
  /** Does the first thread wait for others? One of these may wait for this one. */
  bool
  keptOpen () const
  {
    return state_ == State::Leaving && threads_ > 1;
  }
  void
  become (State state)
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    state_ = state;
    changed_.notify_all();
  }
  void
  waitForOthers ()
  {
    std::unique_lock<std::mutex> lock (mutex_);
    state_ = State::Leaving;
    changed_.wait (lock, [this] { return threads_ == 1; });
  }
  void
  leave ()
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    if (--threads_ == 0)
      state_ = State::Free;
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  State state_{State::Free};
  int threads_{0};
};

thread_local bool within = false;

} // namespace

void
inThisThread (const std::function<void()>& f)
{
  if (within)
    return f();
  std::exception_ptr error;
  within = true;
  SharedLoop::ofThisProcess().run ([&] {
    try {
      f();
    }
    catch (...) {
      error = std::current_exception();
    }
  });
  within = false;
  if (error)
    std::rethrow_exception (error);
}

void
withThreads (int threads, const std::function<void()>& f)
{
  SharedLoop::ofThisProcess(); // notices forks from now on
  if (threads <= 1 || SharedLoop::forked || ThreadTeam::busyHere() ||
      ThreadTeam::ofThisThread().isHeldUp())
    inThisThread (f);
  else
    f();
}

} // namespace pcl_msf
