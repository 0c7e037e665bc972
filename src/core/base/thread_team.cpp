// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/thread_team.h"

#include "core/base/parallel_for.h"
#include "core/base/without_signals.h"
#include <pthread.h>

#include <ctime>
#include <memory>
#include <system_error>
#include <utility>

namespace pcl_msf {

namespace {

constexpr unsigned kPlace = 1U << 16;                   // in the gate's upper half
constexpr unsigned kInside = kPlace - 1U;               // its lower half
constexpr auto kAwake = std::chrono::microseconds (50); // before a thread sleeps
constexpr auto kLongWait = std::chrono::milliseconds (1);
constexpr int kMuch = 4;   // a share of the time that is much to lose: a quarter
constexpr int kAlone = 20; // times the time lost that follow alone: little is lost
constexpr int kMostHelpers = 1023;

thread_local bool busy_here = false;

/** Null until the thread's first loop. */
std::unique_ptr<ThreadTeam>&
teamHere ()
{
  thread_local std::unique_ptr<ThreadTeam> team;
  return team;
}

/** In a forked process: the team's threads are not there, and what they held will never
 * be released, so it is left as it is. */
void
leaveParentsTeam ()
{
  [[maybe_unused]] const ThreadTeam* lost = teamHere().release();
}

/** Tells how long this thread has run on a processor, and how long it has not. */
class StopWatch {
public:
  using Clock = std::chrono::steady_clock;

  Clock::duration
  elapsed () const
  {
    return Clock::now() - begin_;
  }

  Clock::duration
  stopped () const
  {
    return elapsed() - (processorTime() - processor_);
  }

private:
  static std::chrono::nanoseconds
  processorTime ()
  {
    timespec time{};
    clock_gettime (CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds (time.tv_sec) + std::chrono::nanoseconds (time.tv_nsec);
  }

  Clock::time_point begin_{Clock::now()};
  std::chrono::nanoseconds processor_{processorTime()};
};

/** Looks for a while whether something came true, before the thread goes to sleep. */
template <typename Condition>
bool
comesSoon (const Condition& condition)
{
  const auto end = std::chrono::steady_clock::now() + kAwake;
  do {
    for (int i = 0; i < 32; ++i) {
      if (condition())
        return true;
#if defined(__x86_64__) || defined(__i386__)
      __builtin_ia32_pause();
#endif
    }
  }
  while (std::chrono::steady_clock::now() < end);
  return condition();
}

} // namespace

int
threadCount (unsigned wanted)
{
  return static_cast<int> (
      wanted > 0 ? wanted : std::max (1U, std::thread::hardware_concurrency()));
}

ThreadTeam&
ThreadTeam::ofThisThread()
{
  [[maybe_unused]] static const int registered =
      pthread_atfork (nullptr, nullptr, leaveParentsTeam);
  std::unique_ptr<ThreadTeam>& team = teamHere();
  if (!team)
    team = std::make_unique<ThreadTeam>();
  return *team;
}

bool
ThreadTeam::busyHere()
{
  return busy_here;
}

ThreadTeam::~ThreadTeam()
{
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    ended_ = true;
  }
  begun_.notify_all();
  for (std::thread& helper : helpers_)
    helper.join();
}

bool
ThreadTeam::isHeldUp() const
{
  return Clock::now() < alone_until_;
}

ThreadTeam::Clock::duration
ThreadTeam::timeAlone (const LoopTimes& times)
{
  const Clock::duration lost =
      times.stopped + std::min (times.wait, times.helper_stopped);
  // Threads wait a little for each other's memory, too: a small share of their time.
  if (lost <= kLongWait || kMuch * lost <= times.elapsed + times.wait)
    return {};
  return kAlone * lost;
}

void
ThreadTeam::run (const Loop& loop, int threads)
{
  const StopWatch watch;
  const int parts = (loop.n + loop.chunk - 1) / loop.chunk;
  const int helpers =
      isHeldUp()
          ? 0
          : std::max (0,
                      std::min ({threads - 1 - elsewhere_, parts - 1, kMostHelpers}));
  hire (helpers);
  loop_ = loop;
  next_ = 0;
  error_ = nullptr;
  if (helpers > 0)
    open (std::min (helpers, static_cast<int> (helpers_.size())));
  busy_here = true;
  work();
  busy_here = false;
  if (helpers > 0) {
    LoopTimes times{};
    times.elapsed = watch.elapsed();
    times.stopped = watch.stopped();
    close();
    times.wait = watch.elapsed() - times.elapsed;
    times.helper_stopped = Clock::duration (helper_stopped_.load());
    const Clock::duration alone = timeAlone (times);
    if (alone.count() > 0)
      alone_until_ = Clock::now() + alone;
  }
  if (error_)
    std::rethrow_exception (error_);
}

/** Fewer helpers than wanted are no error: the caller does what they would have done.
 */
void
ThreadTeam::hire (int helpers)
{
  if (static_cast<int> (helpers_.size()) >= helpers)
    return;
  const WithoutSignals quiet;
  try {
    while (static_cast<int> (helpers_.size()) < helpers)
      helpers_.emplace_back ([this] { help(); });
  }
  catch (const std::system_error&) { // no more threads
  }
}

/** Lets helpers in, and wakes them. */
void
ThreadTeam::open (int helpers)
{
  helper_stopped_ = 0;
  gate_ = static_cast<unsigned> (helpers) * kPlace;
  ++round_;
  const int asleep = std::min (helpers, sleeping_.load());
  if (asleep == 0)
    return;
  {
    const std::lock_guard<std::mutex> lock (mutex_);
  }
  for (int i = 0; i < asleep; ++i)
    begun_.notify_one();
}

/** Lets nobody in any more, and waits for those who are. */
void
ThreadTeam::close()
{
  gate_ &= kInside;
  const auto empty = [this] { return gate_ == 0; };
  if (comesSoon (empty))
    return;
  std::unique_lock<std::mutex> lock (mutex_);
  caller_sleeps_ = true;
  done_.wait (lock, empty);
  caller_sleeps_ = false;
}

/** A helper's part of a loop. */
void
ThreadTeam::workAside()
{
  const StopWatch watch;
  work();
  const Clock::rep stopped = watch.stopped().count();
  Clock::rep longest = helper_stopped_;
  while (longest < stopped && !helper_stopped_.compare_exchange_weak (longest, stopped))
    ;
}

void
ThreadTeam::help()
{
  busy_here = true;
  unsigned seen = 0;
  while (waitForWork (seen))
    if (!takeJob() && enter()) {
      workAside();
      leave();
    }
}

bool
ThreadTeam::doAside (std::function<void()> job)
{
  hire (elsewhere_ + 1);
  if (static_cast<int> (helpers_.size()) <= elsewhere_)
    return false;
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    jobs_.push_back (std::move (job));
    ++waiting_jobs_;
    ++elsewhere_;
  }
  begun_.notify_one();
  return true;
}

/** Does a job that waits for a helper. */
bool
ThreadTeam::takeJob()
{
  if (waiting_jobs_ == 0)
    return false;
  std::function<void()> job;
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    if (jobs_.empty())
      return false;
    job = std::move (jobs_.front());
    jobs_.pop_front();
    --waiting_jobs_;
  }
  job();
  job = nullptr; // what it holds ends before it counts as done
  --elsewhere_;
  return true;
}

/** False when the team's thread ends, and no job waits. */
bool
ThreadTeam::waitForWork (unsigned& seen)
{
  const auto begun = [&] { return round_ != seen || waiting_jobs_ > 0 || ended_; };
  if (!comesSoon (begun)) {
    std::unique_lock<std::mutex> lock (mutex_);
    ++sleeping_;
    begun_.wait (lock, begun);
    --sleeping_;
  }
  seen = round_;
  return waiting_jobs_ > 0 || !ended_;
}

bool
ThreadTeam::enter()
{
  unsigned gate = gate_;
  while (gate >= kPlace)
    if (gate_.compare_exchange_weak (gate, gate - kPlace + 1))
      return true;
  return false;
}

void
ThreadTeam::leave()
{
  if (--gate_ == 0 && caller_sleeps_) {
    const std::lock_guard<std::mutex> lock (mutex_);
    done_.notify_one();
  }
}

void
ThreadTeam::work()
{
  const Loop loop = loop_;
  try {
    while (true) {
      const int begin = next_.fetch_add (loop.chunk, std::memory_order_relaxed);
      if (begin >= loop.n)
        return;
      loop.part (loop.context, begin, std::min (begin + loop.chunk, loop.n));
    }
  }
  catch (...) {
    next_ = loop.n;
    const std::lock_guard<std::mutex> lock (mutex_);
    if (!error_)
      error_ = std::current_exception();
  }
}

} // namespace pcl_msf
