// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "core/base/order_statistics.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf {

namespace {

constexpr double kHighlights = 0.05; // share of the positive values that has no say
constexpr double kTens = 50.0;       // a unit of shares of 1 does not reach this

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

bool
hasFractions (const cv::Mat& image)
{
  return std::any_of (image.begin<float>(), image.end<float>(), [] (float v) {
    return v != std::floor (v) && std::isfinite (v);
  });
}

/** A dark image of whole numbers may be one in the dark, shares of 1 beside tens are
 * another unit: no exposure changes that much. */
void
requireOneUnit (const std::vector<cv::Mat*>& images, const std::vector<double>& tops)
{
  const auto most = std::max_element (tops.begin(), tops.end());
  for (std::size_t k = 0; k < tops.size(); ++k)
    if (*most > kTens && tops[k] > 0.0 && tops[k] <= 1.0 && hasFractions (*images[k]))
      throw InvalidInput ("intensity: image " + std::to_string (k) + " stays below " +
                          generalText (tops[k]) + ", image " +
                          std::to_string (most - tops.begin()) + " reaches " +
                          generalText (*most) +
                          "; give all that are compared in one unit");
}

} // namespace

double
intensityUnit (const std::vector<cv::Mat*>& images)
{
  std::vector<double> tops;
  for (const cv::Mat* image : images) {
    if (!isRaw (*image))
      return 1.0;
    tops.push_back (brightest (*image));
  }
  requireOneUnit (images, tops);
  const double top = tops.empty() ? 0.0 : *std::max_element (tops.begin(), tops.end());
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
