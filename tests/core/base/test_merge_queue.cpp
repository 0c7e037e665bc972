// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/base/merge_queue.h"

namespace {

using namespace pcl_msf;
using Pair = std::pair<int, int>;

TEST (DisjointSets, SmallestIsTheRootInAnyOrder)
{
  DisjointSets up (6), down (6);
  for (const auto& [a, b] : {Pair (5, 4), Pair (4, 2), Pair (0, 1)}) {
    up.join (a, b);
    down.join (b, a);
  }
  for (const int i : {2, 4, 5}) {
    EXPECT_EQ (up.root (i), 2);
    EXPECT_EQ (down.root (i), 2);
  }
  EXPECT_EQ (up.root (1), 0);
  EXPECT_EQ (up.root (3), 3);
  up.join (1, 5);
  EXPECT_EQ (up.root (4), 0);
}

TEST (MergeQueue, CheapestComesFirstTiesByNumber)
{
  MergeQueue queue (6);
  queue.offer (2.0, 0, 1);
  queue.offer (1.0, 5, 4);
  queue.offer (1.0, 3, 2);
  EXPECT_EQ (queue.next(), Pair (2, 3));
  EXPECT_EQ (queue.next(), Pair (4, 5));
  EXPECT_EQ (queue.next(), Pair (0, 1));
  EXPECT_EQ (queue.next(), std::nullopt);
  EXPECT_TRUE (queue.empty());
}

TEST (MergeQueue, OffersEndWhenOneOfBothMerges)
{
  MergeQueue queue (4);
  queue.offer (3.0, 0, 2);
  queue.offer (3.0, 1, 3);
  queue.offer (4.0, 2, 3);
  queue.merge (0, 1);
  EXPECT_EQ (queue.next(), Pair (2, 3)) << "of those that did not merge";
  EXPECT_EQ (queue.next(), std::nullopt);
  queue.offer (3.0, 0, 2);
  EXPECT_EQ (queue.next(), Pair (0, 2)) << "offered anew";
}

TEST (MergeQueue, PartsTakeTheLinksOfThoseThatTheyAbsorb)
{
  MergeQueue queue (5);
  for (const auto& [a, b] : {Pair (0, 1), Pair (1, 2), Pair (1, 3), Pair (0, 4)})
    queue.link (a, b);
  queue.merge (0, 1);
  EXPECT_EQ (queue.neighbors (0), (std::set<int>{2, 3, 4}));
  EXPECT_EQ (queue.neighbors (2), std::set<int>{0});
  queue.merge (2, 4); // not linked with each other
  EXPECT_EQ (queue.neighbors (2), std::set<int>{0});
  EXPECT_EQ (queue.neighbors (0), (std::set<int>{2, 3}));
  queue.merge (0, 2);
  EXPECT_EQ (queue.partOf (4), 0);
  EXPECT_TRUE (queue.isLeft (0) && queue.hasGrown (0));
  EXPECT_FALSE (queue.isLeft (2));
  EXPECT_TRUE (queue.isLeft (3));
  EXPECT_FALSE (queue.hasGrown (3));
}

} // namespace
