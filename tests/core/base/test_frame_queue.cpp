// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <pcl_msf/errors.h>
#include <pcl_msf/frame_queue.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <numeric>
#include <thread>
#include <vector>

namespace {

using namespace pcl_msf;

using Queue = FrameQueue<std::unique_ptr<int>>; // of what cannot be copied

std::unique_ptr<int>
frame (int number)
{
  return std::make_unique<int> (number);
}

/** All frames until the queue is closed. */
std::vector<int>
popAll (Queue& queue)
{
  std::vector<int> numbers;
  while (const auto next = queue.pop())
    numbers.push_back (**next);
  return numbers;
}

std::vector<int>
upTo (int count)
{
  std::vector<int> numbers (count);
  std::iota (numbers.begin(), numbers.end(), 0);
  return numbers;
}

TEST (FrameQueue, DropsTheOldestAndCountsThem)
{
  Queue queue (2);
  for (int k = 0; k < 5; ++k)
    EXPECT_TRUE (queue.push (frame (k)));
  EXPECT_EQ (queue.dropped(), 3);
  queue.close();
  EXPECT_EQ (popAll (queue), (std::vector<int>{3, 4})) << "what waited is still there";
  EXPECT_EQ (queue.dropped(), 3);
}

TEST (FrameQueue, HoldsTheNewestFrameAlone)
{
  Queue queue;
  queue.push (frame (0));
  queue.push (frame (1));
  EXPECT_EQ (**queue.pop(), 1);
  EXPECT_EQ (queue.dropped(), 1);
}

TEST (FrameQueue, LosesNothingWhereTheSourceWaits)
{
  Queue queue (3);
  std::vector<int> got;
  std::thread consumer ([&] { got = popAll (queue); });
  for (int k = 0; k < 1000; ++k)
    EXPECT_TRUE (queue.pushWhenThereIsRoom (frame (k)));
  queue.close();
  consumer.join();
  EXPECT_EQ (got, upTo (1000));
  EXPECT_EQ (queue.dropped(), 0);
}

TEST (FrameQueue, EveryFrameIsTakenInOrderOrCountedAsDropped)
{
  constexpr int frames = 20000;
  Queue queue (2);
  std::vector<int> got;
  std::thread consumer ([&] { got = popAll (queue); });
  for (int k = 0; k < frames; ++k)
    queue.push (frame (k));
  queue.close();
  consumer.join();
  EXPECT_EQ (static_cast<long> (got.size()) + queue.dropped(), frames);
  EXPECT_TRUE (std::is_sorted (got.begin(), got.end()));
  ASSERT_FALSE (got.empty());
  EXPECT_EQ (got.back(), frames - 1) << "the newest is never dropped";
}

/** Does a call wait until the queue is closed, and what does it say then? */
template <typename Call>
bool
outcomeOnceClosed (Queue& queue, Call call)
{
  std::future<bool> outcome = std::async (std::launch::async, call);
  EXPECT_EQ (outcome.wait_for (std::chrono::milliseconds (30)),
             std::future_status::timeout)
      << "it waits";
  queue.close();
  return outcome.get();
}

TEST (FrameQueue, ClosingWakesWhoeverWaits)
{
  Queue empty;
  EXPECT_FALSE (outcomeOnceClosed (empty, [&] { return empty.pop().has_value(); }));
  Queue full;
  full.push (frame (0));
  EXPECT_FALSE (
      outcomeOnceClosed (full, [&] { return full.pushWhenThereIsRoom (frame (1)); }));
  EXPECT_EQ (popAll (full), upTo (1));
}

TEST (FrameQueue, TakesNothingOnceClosed)
{
  Queue queue;
  queue.close();
  queue.close();
  EXPECT_FALSE (queue.push (frame (0)));
  EXPECT_FALSE (queue.pushWhenThereIsRoom (frame (0)));
  EXPECT_FALSE (queue.pop().has_value());
  EXPECT_EQ (queue.dropped(), 0) << "it says so instead";
}

TEST (FrameQueue, NeedsRoomForOne)
{
  for (const int capacity : {0, -1})
    EXPECT_THROW (Queue queue (capacity), InvalidInput);
}

} // namespace
