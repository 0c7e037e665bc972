// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/point_colors.h"

#include <opencv2/imgproc.hpp>

#include "io/figure_parts.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf::visualization {

namespace {

constexpr double kLeastLight = 0.4;  ///< dark texture keeps this much of its tint
constexpr double kWhiteShare = 0.45; ///< light texture goes so far towards white

} // namespace

cv::Mat
ownColors (const cv::Mat& image, const cv::Size& size)
{
  return io::asBgr (image, size);
}

cv::Mat
tintedColors (const cv::Mat& image, const cv::Size& size, const cv::Vec3b& tint)
{
  const cv::Mat gray = io::asGray (ownColors (image, size));
  cv::Mat brightness;
  gray.convertTo (brightness, CV_32FC1);
  const double white_point = std::max (32.0, percentile (brightness, 0.95));
  cv::Mat colors (size, CV_8UC3);
  for (int row = 0; row < size.height; ++row)
    for (int col = 0; col < size.width; ++col) {
      const double light =
          std::min (1.0, gray.at<unsigned char> (row, col) / white_point);
      const double shade =
          kLeastLight + (1.0 - kLeastLight) * std::min (1.0, 1.5 * light);
      const double white = kWhiteShare * std::max (0.0, (light - 0.4) / 0.6);
      for (int c = 0; c < 3; ++c)
        colors.at<cv::Vec3b> (row, col)[c] = cv::saturate_cast<unsigned char> (
            (1.0 - white) * shade * tint[c] + white * 255.0);
    }
  return colors;
}

cv::Mat
mappedColors (const cv::Mat& values, double maximum, int color_map)
{
  CV_Assert (values.type() == CV_32FC1);
  const double scale = maximum > 0.0 ? 255.0 / maximum : 0.0;
  cv::Mat levels (values.size(), CV_8UC1, cv::Scalar (0));
  cv::Mat unknown (values.size(), CV_8UC1, cv::Scalar (0));
  for (int row = 0; row < values.rows; ++row)
    for (int col = 0; col < values.cols; ++col) {
      const float value = values.at<float> (row, col);
      if (std::isfinite (value))
        levels.at<unsigned char> (row, col) =
            cv::saturate_cast<unsigned char> (scale * value);
      else
        unknown.at<unsigned char> (row, col) = 255;
    }
  cv::Mat colors;
  cv::applyColorMap (levels, colors, color_map);
  colors.setTo (cv::Scalar (kUnknownColor), unknown);
  return colors;
}

double
percentile (const cv::Mat& values, double share)
{
  std::vector<float> known;
  for (int row = 0; row < values.rows; ++row)
    for (int col = 0; col < values.cols; ++col)
      if (std::isfinite (values.at<float> (row, col)))
        known.push_back (values.at<float> (row, col));
  if (known.empty())
    return 0.0;
  const auto nth =
      known.begin() + std::lround (share * static_cast<double> (known.size() - 1));
  std::nth_element (known.begin(), nth, known.end());
  return *nth;
}

cv::Mat
lengths (const cv::Mat& vectors)
{
  CV_Assert (vectors.type() == CV_32FC3);
  cv::Mat result (vectors.size(), CV_32FC1);
  for (int row = 0; row < vectors.rows; ++row)
    for (int col = 0; col < vectors.cols; ++col)
      result.at<float> (row, col) =
          static_cast<float> (cv::norm (vectors.at<cv::Vec3f> (row, col)));
  return result;
}

} // namespace pcl_msf::visualization
