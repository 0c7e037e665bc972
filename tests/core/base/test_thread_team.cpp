// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/base/meanwhile.h"
#include "core/base/parallel_for.h"

#include <chrono>
#include <future>
#include <mutex>
#include <set>
#include <thread>

namespace {

using namespace pcl_msf;
using std::chrono::milliseconds;

void
spin (milliseconds duration)
{
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + duration;
  while (Clock::now() < end)
    ;
}

TEST (ThreadTeam, WhoIsHeldUpByOtherProgramsWorksAlone)
{
  const milliseconds none (0);
  const auto alone = [] (const ThreadTeam::LoopTimes& times) {
    return ThreadTeam::timeAlone (times) > milliseconds (0);
  };
  EXPECT_TRUE (alone ({milliseconds (10), milliseconds (5), none, none}));
  EXPECT_TRUE (alone ({milliseconds (2), none, milliseconds (5), milliseconds (5)}));
  EXPECT_FALSE (alone ({milliseconds (10), none, none, none}));
  EXPECT_FALSE (alone ({milliseconds (1), none, milliseconds (50), none}))
      << "the helper had more to do";
  EXPECT_FALSE (alone ({milliseconds (10), none, none, milliseconds (5)}))
      << "nobody waited for it";
  EXPECT_FALSE (alone ({milliseconds (30), milliseconds (2), none, none}))
      << "a small share";
  EXPECT_FALSE (alone (
      {std::chrono::microseconds (900), std::chrono::microseconds (800), none, none}))
      << "a moment";
}

/** How many threads share a loop that gives each of them time to come. */
int
threadsOfLoop (int threads)
{
  std::mutex mutex;
  std::set<std::thread::id> seen;
  parallelFor (threads, 20, 1, [&] (int) {
    {
      const std::lock_guard<std::mutex> lock (mutex);
      seen.insert (std::this_thread::get_id());
    }
    spin (milliseconds (1));
  });
  return static_cast<int> (seen.size());
}

TEST (ThreadTeam, WhoDoesSomethingElseMeanwhileDoesNotHelp)
{
  const ThreadTeam& team = ThreadTeam::ofThisThread();
  std::promise<void> enough;
  auto other = meanwhile (2, [&] { enough.get_future().wait(); });
  EXPECT_EQ (team.elsewhere(), 1);
  EXPECT_EQ (threadsOfLoop (2), 1);
  EXPECT_LE (threadsOfLoop (3), 2);
  enough.set_value();
  other.get();
  while (team.elsewhere() > 0) // what it holds ends
    std::this_thread::yield();
  auto later = meanwhile (1, [] {});
  EXPECT_EQ (team.elsewhere(), 0) << "this thread will do it itself";
  later.get();
}

TEST (ThreadTeam, WhoIsDoneElsewhereHelpsBeforeItIsAskedForItsResult)
{
  const ThreadTeam& team = ThreadTeam::ofThisThread();
  auto other = meanwhile (2, [] { return 7; });
  while (team.elsewhere() > 0)
    std::this_thread::yield();
  EXPECT_EQ (other.get(), 7);
}

} // namespace
