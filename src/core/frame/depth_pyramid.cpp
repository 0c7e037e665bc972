// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/frame/depth_pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_msf {

namespace {

/** Inverse depths of the 3x3 block around a pixel; outside the image: none. */
std::array<float, 9>
block (const cv::Mat& w, int x, int y)
{
  std::array<float, 9> values{};
  for (int dy = -1; dy <= 1; ++dy) {
    const int yy = y + dy;
    if (yy < 0 || yy >= w.rows)
      continue;
    const float* row = w.ptr<float> (yy);
    for (int dx = -1; dx <= 1; ++dx)
      if (x + dx >= 0 && x + dx < w.cols)
        values[(dy + 1) * 3 + dx + 1] = row[x + dx];
  }
  return values;
}

float
averageOfSameSurface (const std::array<float, 9>& values,
                      float noise,
                      const FrameTuning& tuning)
{
  static constexpr std::array<float, 9> kWeights{1, 2, 1, 2, 4, 2, 1, 2, 1};
  float lead = values[4];
  if (lead <= 0.0f)
    lead = *std::max_element (values.begin(), values.end());
  if (lead <= 0.0f)
    return 0.0f;
  const float tolerance =
      std::max (tuning.same_sigmas * noise, tuning.same_surface * lead);
  float sum = 0.0f;
  float weight = 0.0f;
  for (int i = 0; i < 9; ++i)
    if (values[i] > 0.0f && std::abs (values[i] - lead) < tolerance) {
      sum += kWeights[i] * values[i];
      weight += kWeights[i];
    }
  return sum / weight;
}

} // namespace

cv::Mat
inverseDepth (const cv::Mat& depth, double min_depth, double max_depth)
{
  cv::Mat result (depth.size(), CV_32FC1);
  const auto low = static_cast<float> (std::max (min_depth, 1e-6));
  const auto high = static_cast<float> (max_depth);
  for (int y = 0; y < depth.rows; ++y) {
    const float* z = depth.ptr<float> (y);
    float* w = result.ptr<float> (y);
    for (int x = 0; x < depth.cols; ++x)
      w[x] = z[x] >= low && z[x] <= high ? 1.0f / z[x] : 0.0f;
  }
  return result;
}

cv::Mat
halveInverseDepth (const cv::Mat& w, double noise, const FrameTuning& tuning)
{
  cv::Mat result ((w.rows + 1) / 2, (w.cols + 1) / 2, CV_32FC1);
  for (int y = 0; y < result.rows; ++y)
    for (int x = 0; x < result.cols; ++x)
      result.at<float> (y, x) = averageOfSameSurface (
          block (w, 2 * x, 2 * y), static_cast<float> (noise), tuning);
  return result;
}

} // namespace pcl_msf
