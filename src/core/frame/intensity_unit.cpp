// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/order_statistics.h"
#include <pcl_msf/cloud_conversions.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf {

namespace {

constexpr double kHighlights = 0.05; // share of the positive values that has no say

/** What all positive values but the highlights stay below; 0 without one. */
double
brightest (const cv::Mat& image)
{
  std::vector<float> values;
  values.reserve (image.total());
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u)
      if (const float value = image.at<float> (v, u);
          value > 0.0f && std::isfinite (value))
        values.push_back (value);
  if (values.empty())
    return 0.0;
  return quantile (values, 1.0 - kHighlights);
}

bool
isRaw (const cv::Mat& image)
{
  return image.type() == CV_32FC1 && !image.empty();
}

} // namespace

double
intensityUnit (const std::vector<cv::Mat*>& images)
{
  double top = 0.0;
  for (const cv::Mat* image : images) {
    if (!isRaw (*image))
      return 1.0;
    top = std::max (top, brightest (*image));
  }
  if (top <= 2.0)
    return top <= 1.0 ? 1.0 : 2.0;
  double unit = 255.0;
  while (unit < top)
    unit = 2.0 * unit + 1.0;
  return unit;
}

void
normalizeIntensity (const std::vector<cv::Mat*>& images, double unit)
{
  for (const cv::Mat* image : images)
    if (!isRaw (*image))
      return;
  for (cv::Mat* image : images) {
    cv::Mat scaled = *image / unit;
    for (int v = 0; v < scaled.rows; ++v)
      for (int u = 0; u < scaled.cols; ++u) {
        float& value = scaled.at<float> (v, u);
        value = std::isfinite (value) ? std::clamp (value, 0.0f, 1.0f) : 0.0f;
      }
    *image = scaled;
  }
}

void
normalizeIntensity (const std::vector<cv::Mat*>& images)
{
  normalizeIntensity (images, intensityUnit (images));
}

void
normalizeIntensity (cv::Mat& first, cv::Mat& second)
{
  normalizeIntensity ({&first, &second});
}

} // namespace pcl_msf
