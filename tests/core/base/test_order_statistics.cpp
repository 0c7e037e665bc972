// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/base/bilinear.h"
#include "core/base/order_statistics.h"

namespace {

using namespace pcl_msf;

TEST (OrderStatistics, CountsFromTheSmallest)
{
  std::vector<float> values{4, 1, 3, 2};
  EXPECT_EQ (nthSmallest (values, 0), 1);
  EXPECT_EQ (nthSmallest (values, 3), 4);
}

TEST (OrderStatistics, MedianIsTheUpperOfTwoQuantileTheLower)
{
  std::vector<int> values{40, 10, 30, 20};
  EXPECT_EQ (median (values), 30);
  EXPECT_EQ (quantile (values, 0.5), 20);
  values.push_back (50);
  EXPECT_EQ (median (values), 30);
  EXPECT_EQ (quantile (values, 0.5), 30);
  EXPECT_EQ (quantile (values, 0.0), 10);
  EXPECT_EQ (quantile (values, 0.99), 40);
  EXPECT_EQ (quantile (values, 1.0), 50);
  std::vector<int> one{7};
  EXPECT_EQ (median (one), 7);
  EXPECT_EQ (quantile (one, 0.9), 7);
}

TEST (Bilinear, SharesAreOfTheRightAndTheLowerValues)
{
  EXPECT_EQ (bilinear (0.0f, 0.0f, 1.0f, 2.0f, 4.0f, 8.0f), 1.0f);
  EXPECT_EQ (bilinear (1.0f, 0.0f, 1.0f, 2.0f, 4.0f, 8.0f), 2.0f);
  EXPECT_EQ (bilinear (0.0f, 1.0f, 1.0f, 2.0f, 4.0f, 8.0f), 4.0f);
  EXPECT_EQ (bilinear (1.0f, 1.0f, 1.0f, 2.0f, 4.0f, 8.0f), 8.0f);
  EXPECT_EQ (bilinear (0.5, 0.25, 1.0, 2.0, 4.0, 8.0), 0.75 * 1.5 + 0.25 * 6.0);
}

} // namespace
