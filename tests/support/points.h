// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/segments/segment_pixels.h"

namespace pcl_msf {
namespace test {

/** \brief All points of a level, without a change of brightness. */
inline SegmentPixels
pointsOf (const FrameLevel& level,
          const cv::Mat& labels,
          int segments,
          const NoiseModel& noise,
          double relative_tolerance)
{
  PointOptions options;
  options.noise = noise;
  options.relative_tolerance = relative_tolerance;
  return groupPixels (level, labels, segments, options);
}

/** \brief Sampled from an image-sized function of the pixel. */
template <typename Function>
cv::Mat
image (int width, int height, const Function& function)
{
  cv::Mat result (height, width, CV_32FC1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      result.at<float> (y, x) = static_cast<float> (function (x, y));
  return result;
}

} // namespace test
} // namespace pcl_msf
