// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "evaluation/check_images.h"
#include <pcl_msf/evaluation/flow_errors.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace pcl_msf::evaluation {

namespace {

constexpr int kSteps = 50; // of a curve

/** Mean of a curve relative to its beginning: the points' first numbers are what they
 * are sorted by, the second ones the errors. */
double
areaUnder (std::vector<std::pair<float, float>>& points)
{
  std::stable_sort (points.begin(), points.end(), [] (const auto& a, const auto& b) {
    return a.first < b.first;
  });
  std::vector<double> sums (1, 0.0);
  for (const auto& point : points)
    sums.push_back (sums.back() + point.second);
  const std::size_t n = points.size();
  double area = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const std::size_t left = std::max<std::size_t> (1, n * (kSteps - i) / kSteps);
    area += sums[left] / static_cast<double> (left);
  }
  return area / kSteps * static_cast<double> (n) / sums.back();
}

} // namespace

double
sparsificationError (const cv::Mat& errors,
                     const cv::Mat& deviation,
                     const cv::Mat& mask)
{
  requireImage ("errors", errors, CV_32FC1, mask.size());
  requireImage ("deviation", deviation, CV_32FC1, mask.size());
  requireImage ("mask", mask, CV_8UC1, mask.size());
  std::vector<std::pair<float, float>> sorted, ideal;
  bool any = false;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) {
      const float error = errors.at<float> (y, x);
      const float by = deviation.at<float> (y, x);
      if (mask.at<unsigned char> (y, x) != 255 || !std::isfinite (error))
        continue;
      sorted.emplace_back (
          std::isfinite (by) ? by : std::numeric_limits<float>::infinity(), error);
      ideal.emplace_back (error, error);
      any |= error > 0.0f;
    }
  if (!any)
    return std::numeric_limits<double>::quiet_NaN();
  return areaUnder (sorted) - areaUnder (ideal);
}

} // namespace pcl_msf::evaluation
