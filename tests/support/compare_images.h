// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include <pcl_msf/rigid_pose.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_msf::testing {

/** \brief Two float images of any number of channels are known at the same pixels and
 * agree there, and more than `least` values are known. \param zero_is_none 0 counts as
 * unknown in both */
inline void
expectSame (const cv::Mat& actual,
            const cv::Mat& expected,
            double tolerance,
            int least,
            bool zero_is_none = false)
{
  ASSERT_EQ (actual.size(), expected.size());
  ASSERT_EQ (actual.type(), expected.type());
  const int values = actual.cols * actual.channels();
  const auto known = [zero_is_none] (float value) {
    return std::isfinite (value) && !(zero_is_none && value == 0.0F);
  };
  int compared = 0, differing = 0;
  double worst = 0.0;
  for (int row = 0; row < actual.rows; ++row)
    for (int i = 0; i < values; ++i) {
      const float a = actual.ptr<float> (row)[i], b = expected.ptr<float> (row)[i];
      differing += known (a) != known (b);
      if (!known (a) || !known (b))
        continue;
      ++compared;
      worst = std::max (worst, std::abs (double{a} - double{b}));
    }
  EXPECT_EQ (differing, 0) << "values known in one image only";
  EXPECT_GT (compared, least);
  EXPECT_LE (worst, tolerance);
}

/** \brief Two 8-bit images are the same. */
inline void
expectSameColor (const cv::Mat& actual, const cv::Mat& expected)
{
  ASSERT_EQ (actual.type(), expected.type());
  EXPECT_EQ (cv::norm (actual, expected, cv::NORM_INF), 0.0);
}

/** \brief Two poses agree to 1e-5 in every parameter. */
inline void
expectSamePose (const std::optional<RigidPose>& actual, const RigidPose& expected)
{
  ASSERT_TRUE (actual);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR (actual->parameters[i], expected.parameters[i], 1e-5);
}

/** \brief Share of pixels whose masks agree. */
inline double
agreement (const cv::Mat& a, const cv::Mat& b)
{
  EXPECT_EQ (a.type(), CV_8UC1);
  EXPECT_EQ (a.size(), b.size());
  return 1.0 - cv::countNonZero (a != b) / static_cast<double> (a.total());
}

} // namespace pcl_msf::testing
