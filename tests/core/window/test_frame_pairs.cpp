// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/window/frame_pairs.h"

namespace {

using pcl_msf::FramePairs;

TEST (FramePairs, AllPairsOnceForwardFromTheFirst)
{
  for (const int n : {2, 3, 4, 8}) {
    const FramePairs pairs (n, 0);
    EXPECT_EQ (pairs.count(), n * (n - 1) / 2);
    int adjacent = 0;
    for (const FramePairs::Pair& pair : pairs.all()) {
      EXPECT_LT (pair.from, pair.to);
      EXPECT_EQ (pair.adjacent, pair.to - pair.from == 1);
      adjacent += pair.adjacent;
    }
    EXPECT_EQ (adjacent, n - 1);
  }
}

TEST (FramePairs, LeadAwayFromTheReference)
{
  const FramePairs pairs (5, 2);
  const auto leads = [&] (int a, int b) {
    const FramePairs::Pair& pair = pairs[pairs.between (a, b)];
    return pair.from == a && pair.to == b;
  };
  EXPECT_TRUE (leads (2, 0) && leads (2, 1) && leads (2, 3) && leads (2, 4));
  EXPECT_TRUE (leads (1, 0) && leads (3, 4));
  EXPECT_TRUE (leads (0, 3) && leads (1, 4)) << "across the reference: forward";
  EXPECT_EQ (pairs.between (0, 3), pairs.between (3, 0));
  EXPECT_EQ (pairs.fromReference (4), pairs.between (2, 4));
}

TEST (FramePairs, ChainsWalkAdjacentPairs)
{
  const FramePairs pairs (5, 2);
  const auto steps = pairs.chain (pairs.between (0, 4));
  ASSERT_EQ (steps.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ (steps[i].pair, pairs.between (i, i + 1));
    EXPECT_EQ (steps[i].inverse, i < 2) << "pairs before the reference lead backward";
  }
  const auto back = pairs.chain (pairs.between (2, 0));
  ASSERT_EQ (back.size(), 2U);
  EXPECT_EQ (back[0].pair, pairs.between (2, 1));
  EXPECT_FALSE (back[0].inverse || back[1].inverse);
}

} // namespace
