// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/segments/segment_pixels.h"
#include <gmock/gmock.h>

#include <algorithm>

namespace {

using namespace pcl_msf;

constexpr int kSide = 80;
constexpr int kMost = 64;
constexpr int kLeast = 2048; // of all segments

/** A flat wall cut into upright strips of equal width. */
SegmentPixels
stripsOf (int strips, const PointOptions& options)
{
  FrameLevel level;
  level.camera = {100.0, 100.0, 39.5, 39.5};
  level.inverse_depth = cv::Mat (kSide, kSide, CV_32FC1, cv::Scalar (0.5));
  level.normals = cv::Mat (kSide, kSide, CV_32FC3, cv::Scalar (0.0, 0.0, -1.0));
  cv::Mat labels (kSide, kSide, CV_32SC1);
  for (int x = 0; x < kSide; ++x)
    labels.col (x) = x * strips / kSide;
  return groupPixels (level, labels, strips, options);
}

/** At most kMost points of each. */
SegmentPixels
stripsOf (int strips)
{
  PointOptions options;
  options.max_per_segment = kMost;
  options.tuning.least_samples = kLeast;
  options.thinning = 4; // not of samples
  return stripsOf (strips, options);
}

PointOptions
thinned (int thinning)
{
  PointOptions options;
  options.thinning = thinning;
  return options;
}

TEST (SegmentPixels, KeepsSamplesOfEachSegment)
{
  const SegmentPixels many = stripsOf (40);
  for (int k = 0; k < 40; ++k)
    EXPECT_EQ (many.size (k), kMost);
}

TEST (SegmentPixels, FewSegmentsHaveMoreSamplesEach)
{
  EXPECT_EQ (stripsOf (1).size (0), kLeast);
  EXPECT_EQ (stripsOf (8).size (5), kLeast / 8);
  EXPECT_EQ (stripsOf (80).size (7), kMost);
  EXPECT_EQ (stripsOf (80).pixels (7), kMost);
}

TEST (SegmentPixels, ThinnedPointsStandForAllPixels)
{
  for (const int thinning : {1, 2, 4}) {
    const SegmentPixels points = stripsOf (2, thinned (thinning));
    for (int k = 0; k < 2; ++k) {
      EXPECT_EQ (points.size (k), kSide * kSide / 2 / thinning);
      EXPECT_EQ (points.pixels (k), kSide * kSide / 2);
    }
    EXPECT_EQ (points.icp_count, kSide * kSide);
    EXPECT_EQ (points.pixel_area, 1);
  }
}

TEST (SegmentPixels, AThinnedSegmentHasPixelsAllOverItInRasterOrder)
{
  for (const int thinning : {2, 4}) {
    const SegmentPixels points = stripsOf (1, thinned (thinning));
    EXPECT_TRUE (std::is_sorted (points.pixel.begin(), points.pixel.end()));
    std::vector<int> columns (kSide, 0);
    std::vector<int> cells (kSide / 4 * kSide / 4, 0);
    for (const int pixel : points.pixel) {
      ++columns[pixel % kSide];
      ++cells[pixel / kSide / 4 * (kSide / 4) + pixel % kSide / 4];
    }
    EXPECT_THAT (columns, testing::Each (kSide / thinning));
    EXPECT_THAT (cells, testing::Each (16 / thinning));
  }
}

TEST (SegmentPixels, SmallSegmentsAreThinnedLessOrNotAtAll)
{
  PointOptions options = thinned (4);
  options.tuning.least_points = 45;
  // Strips of 160 pixels keep every second one: 40 would be too few.
  const SegmentPixels half = stripsOf (40, options);
  EXPECT_EQ (half.size (3), 80);
  EXPECT_EQ (half.pixels_per_point[3], 2);
  options.tuning.least_points = 81;
  const SegmentPixels all = stripsOf (40, options);
  EXPECT_EQ (all.size (39), 160);
  EXPECT_EQ (all.pixels (39), 160);
}

} // namespace
