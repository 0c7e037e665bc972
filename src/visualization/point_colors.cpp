// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "visualization/point_colors.h"

#include <opencv2/imgproc.hpp>

#include "core/base/order_statistics.h"
#include "io/base/drawing.h"
#include "io/base/label_colors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_msf::visualization {

namespace {

constexpr double kLeastLight = 0.4;  ///< dark texture keeps this much of its tint
constexpr double kWhiteShare = 0.45; ///< light texture goes so far towards white

constexpr double kDarkest = 50.0;   ///< of a shape without colours, seen edge-on
constexpr double kLightest = 215.0; ///< seen from the front
constexpr float kDarkLabel = 95.0F; ///< least light of a label, of 255
constexpr double kTypicalShare = 0.98;

/** Vector between the neighbours of a pixel, or from it to the one that there is; zero
 * without any. */
cv::Vec3f
slope (const cv::Mat& points, const cv::Point& at, const cv::Point& step)
{
  const cv::Rect whole ({}, points.size());
  const auto known = [&] (const cv::Point& p) {
    return whole.contains (p) && std::isfinite (points.at<cv::Vec3f> (p)[2]);
  };
  const cv::Point before = known (at - step) ? at - step : at;
  const cv::Point after = known (at + step) ? at + step : at;
  return points.at<cv::Vec3f> (after) - points.at<cv::Vec3f> (before);
}

/** Light of a lamp at the sensor. */
cv::Mat
litShape (const cv::Mat& points)
{
  cv::Mat gray (points.size(), CV_8UC1, cv::Scalar (128));
  for (int row = 0; row < points.rows; ++row)
    for (int col = 0; col < points.cols; ++col) {
      const auto& p = points.at<cv::Vec3f> (row, col);
      if (!std::isfinite (p[2]))
        continue;
      const cv::Vec3f normal =
          slope (points, {col, row}, {1, 0}).cross (slope (points, {col, row}, {0, 1}));
      const double size = cv::norm (normal) * cv::norm (p);
      if (size > 0.0)
        gray.at<unsigned char> (row, col) = cv::saturate_cast<unsigned char> (
            kDarkest + (kLightest - kDarkest) * std::abs (normal.dot (p)) / size);
    }
  return gray;
}

/** The smallest of some numbers of one digit that is not below. */
double
roundUp (double number)
{
  const double power = std::pow (10.0, std::floor (std::log10 (number)));
  for (const double digit : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (number <= 1.001 * digit * power)
      return digit * power;
  return 10.0 * power;
}

} // namespace

cv::Mat
ownColors (const cv::Mat& image, const cv::Mat& points)
{
  return io::asBgr (image.empty() ? litShape (points) : image, points.size());
}

cv::Vec3b
lightLabelColor (int label)
{
  const cv::Vec3f bgr = io::labelColor (label);
  const float light = 0.114F * bgr[0] + 0.587F * bgr[1] + 0.299F * bgr[2];
  const float white = std::max (0.0F, (kDarkLabel - light) / (255.0F - light));
  return (1.0F - white) * bgr + white * cv::Vec3f::all (255.0F);
}

ColorScale
colorScale (const cv::Mat& values, double maximum, const std::string& title, int map)
{
  double end = maximum > 0.0 ? maximum : percentile (values, kTypicalShare);
  if (!(end > 0.0))
    end = 1.0;
  ColorScale scale{0.0, maximum > 0.0 ? maximum : roundUp (end), title, map};
  cv::Mat beyond;
  cv::compare (values, scale.maximum, beyond, cv::CMP_GT);
  scale.open = cv::countNonZero (beyond) > 0;
  return scale;
}

cv::Mat
whereVisible (const cv::Mat& values, const cv::Mat& visibility)
{
  cv::Mat result = values.clone();
  result.setTo (cv::Scalar (std::numeric_limits<float>::quiet_NaN()),
                visibility != pixelValue (Visibility::Visible));
  return result;
}

cv::Mat
tintedColors (const cv::Mat& image, const cv::Mat& points, const cv::Vec3b& tint)
{
  const cv::Size size = points.size();
  const cv::Mat gray = io::asGray (ownColors (image, points));
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
  return nthSmallest (known,
                      std::lround (share * static_cast<double> (known.size() - 1)));
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
