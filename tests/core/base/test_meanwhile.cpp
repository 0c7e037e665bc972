// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/base/meanwhile.h"
#include "core/base/parallel_for.h"

#include <csignal>
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

TEST (Meanwhile, HandsOnExceptions)
{
  for (const int threads : {1, 2}) {
    auto fails = meanwhile (threads, [] () -> int { throw std::runtime_error ("x"); });
    EXPECT_THROW (fails.get(), std::runtime_error);
  }
}

} // namespace
