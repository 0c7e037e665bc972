// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/frame/noise.h"

#include "core/base/order_statistics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf {

namespace {

constexpr int kStride = 2; // every second row and column is sample enough

} // namespace

double
estimateIntensityNoise (const cv::Mat& image)
{
  std::vector<float> responses;
  responses.reserve (image.total() / (kStride * kStride));
  for (int y = 1; y + 1 < image.rows; y += kStride) {
    const float* a = image.ptr<float> (y - 1);
    const float* b = image.ptr<float> (y);
    const float* c = image.ptr<float> (y + 1);
    for (int x = 1; x + 1 < image.cols; x += kStride) {
      const float top = a[x - 1] - 2.0f * a[x] + a[x + 1];
      const float mid = b[x - 1] - 2.0f * b[x] + b[x + 1];
      const float low = c[x - 1] - 2.0f * c[x] + c[x + 1];
      responses.push_back (std::abs (top - 2.0f * mid + low));
    }
  }
  if (responses.empty())
    return 0.0;
  // The mask's squares sum to 36.
  return kMadToSigma * quantile (responses, 0.5) / 6.0;
}

double
estimateInverseDepthNoise (const cv::Mat& inverse_depth)
{
  std::vector<float> differences;
  differences.reserve (inverse_depth.total() / (kStride * kStride));
  for (int y = 0; y < inverse_depth.rows; y += kStride) {
    const float* w = inverse_depth.ptr<float> (y);
    for (int x = 1; x + 1 < inverse_depth.cols; x += kStride)
      if (w[x - 1] > 0.0f && w[x] > 0.0f && w[x + 1] > 0.0f)
        differences.push_back (std::abs (w[x - 1] - 2.0f * w[x] + w[x + 1]));
  }
  if (differences.empty())
    return 0.0;
  // Quantized disparity has many exact zeros: the upper quartile sees the steps.
  const double by_median = kMadToSigma * quantile (differences, 0.5);
  const double by_quartile = quantile (differences, 0.75) / 1.1503;
  return std::max (by_median, by_quartile) / std::sqrt (6.0);
}

} // namespace pcl_msf
