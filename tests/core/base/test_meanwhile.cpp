// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/base/meanwhile.h"
#include "core/base/parallel_for.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <future>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace {

using namespace pcl_msf;

/** Does a thread of this process get the signal that ends programs? */
bool
getsSignals ()
{
  sigset_t blocked;
  pthread_sigmask (SIG_SETMASK, nullptr, &blocked);
  return sigismember (&blocked, SIGINT) == 0;
}

TEST (Meanwhile, AnotherThreadWorksAndGetsNoSignals)
{
  const std::thread::id here = std::this_thread::get_id();
  auto there = meanwhile (2, [] {
    return std::pair{std::this_thread::get_id(), getsSignals()};
  });
  const auto [thread, signals] = there.get();
  EXPECT_NE (thread, here);
  EXPECT_FALSE (signals);
  EXPECT_TRUE (getsSignals()) << "the caller's are as before";
}

TEST (Meanwhile, OneThreadWorksWhenAsked)
{
  bool done = false;
  auto later = meanwhile (1, [&] {
    done = true;
    return std::this_thread::get_id();
  });
  EXPECT_FALSE (done);
  EXPECT_EQ (later.get(), std::this_thread::get_id());
  std::vector<char> here (4);
  parallelFor (4, 4, 1, [&] (int i) {
    auto within = meanwhile (4, [] { return std::this_thread::get_id(); });
    here[i] = within.get() == std::this_thread::get_id();
  });
  EXPECT_EQ (here, std::vector<char> (4, 1)) << "threads of a loop start no others";
}

TEST (Meanwhile, OneHelperDoesOneJobAfterTheOther)
{
  std::vector<std::thread::id> helpers;
  std::thread ([&] { // with a team of its own
    const ThreadTeam& team = ThreadTeam::ofThisThread();
    for (int i = 0; i < 3; ++i) {
      auto job = meanwhile (2, [] { return std::this_thread::get_id(); });
      helpers.push_back (job.get());
      while (team.elsewhere() > 0)
        std::this_thread::yield();
    }
  })
      .join();
  EXPECT_EQ (helpers, std::vector<std::thread::id> (3, helpers[0]));
}

TEST (Meanwhile, SeveralAtOnceHaveAHelperEach)
{
  std::promise<void> first;
  auto waits = meanwhile (3, [&] { first.get_future().wait(); });
  auto lets_go = meanwhile (3, [&] { first.set_value(); });
  waits.get();
  lets_go.get();
}

TEST (Meanwhile, EndsWhenTheJobIsDone)
{
  std::atomic<bool> done{false};
  {
    const auto unasked = meanwhile (2, [&] {
      std::this_thread::sleep_for (std::chrono::milliseconds (20));
      done = true;
    });
  }
  EXPECT_TRUE (done);
}

TEST (Meanwhile, HandsOnExceptions)
{
  for (const int threads : {1, 2}) {
    auto fails = meanwhile (threads, [] () -> int { throw std::runtime_error ("x"); });
    EXPECT_THROW (fails.get(), std::runtime_error);
  }
}

} // namespace
