// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/segments/segment_pixels.h"

namespace {

using namespace pcl_msf;

constexpr int kSide = 80;
constexpr int kMost = 64;
constexpr int kLeast = 2048; // of all segments

/** A flat wall cut into upright strips of equal width, at most kMost points of each. */
SegmentPixels
stripsOf (int strips)
{
  FrameLevel level;
  level.camera = {100.0, 100.0, 39.5, 39.5};
  level.inverse_depth = cv::Mat (kSide, kSide, CV_32FC1, cv::Scalar (0.5));
  level.normals = cv::Mat (kSide, kSide, CV_32FC3, cv::Scalar (0.0, 0.0, -1.0));
  cv::Mat labels (kSide, kSide, CV_32SC1);
  for (int x = 0; x < kSide; ++x)
    labels.col (x) = x * strips / kSide;
  PointOptions options;
  options.max_per_segment = kMost;
  options.tuning.least_samples = kLeast;
  return groupPixels (level, labels, strips, options);
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
}

} // namespace
