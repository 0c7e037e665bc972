// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "visualization/closed_cloud.h"
#include <gmock/gmock.h>

#include <limits>

namespace {

using namespace pcl_msf::visualization;

const cv::Size kSize (40, 20);

/** A wall at 2 m, points 2 cm apart; the right half lies deeper by a share. */
cv::Mat
wall (float deeper = 0.0F)
{
  cv::Mat points (kSize, CV_32FC3);
  for (int row = 0; row < kSize.height; ++row)
    for (int col = 0; col < kSize.width; ++col)
      points.at<cv::Vec3f> (row, col) =
          (col < 20 ? 1.0F : 1.0F + deeper) *
          cv::Vec3f (0.02F * (col - 20.0F), 0.02F * (row - 10.0F), 2.0F);
  return points;
}

/** Triangles when the right half moves. */
std::vector<cv::Vec3i>
seams (const cv::Mat& points, const cv::Scalar& motion)
{
  cv::Mat moved = points.clone();
  moved.colRange (20, 40) += motion;
  return closedCloud (points, moved, cv::Mat (kSize, CV_8UC3, cv::Scalar::all (9)))
      .triangles;
}

TEST (Seams, CracksOfOneSurfaceAreClosed)
{
  const std::vector<cv::Vec3i> closed = seams (wall(), {0.1, 0, 0}); // 5 points apart
  ASSERT_EQ (closed.size(), 2U * 19U) << "two between each four of columns 19 and 20";
  for (const cv::Vec3i& triangle : closed)
    for (int i = 0; i < 3; ++i)
      EXPECT_THAT (triangle[i] % kSize.width, ::testing::AnyOf (19, 20));
}

TEST (Seams, WhatIsNoCrackStaysOpen)
{
  EXPECT_TRUE (seams (wall(), {0, 0, 0}).empty());
  EXPECT_TRUE (seams (wall(), {0.005, 0, 0}).empty()) << "points cover it";
  EXPECT_TRUE (seams (wall(), {0.3, 0, 0}).empty()) << "15 points apart: torn";
  EXPECT_TRUE (seams (wall(), {-0.1, 0, 0}).empty()) << "one over the other";
}

TEST (Seams, OtherSurfacesStayApart)
{
  EXPECT_TRUE (seams (wall (0.2F), {0.1, 0, 0}).empty()) << "0.4 m behind";
  EXPECT_FALSE (seams (wall (0.015F), {0.1, 0, 0}).empty()) << "a step of the sensor";
}

TEST (Seams, UnknownPointsHaveNone)
{
  cv::Mat points = wall();
  points.col (20).setTo (cv::Scalar::all (std::numeric_limits<float>::quiet_NaN()));
  EXPECT_TRUE (seams (points, {0.1, 0, 0}).empty());
}

} // namespace
