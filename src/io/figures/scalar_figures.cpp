// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/order_statistics.h"
#include "io/base/drawing.h"
#include <pcl_msf/io/figures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_msf::io {

namespace {

constexpr int kBarHeight = 34;

std::vector<float>
finiteValues (const cv::Mat& scalar)
{
  std::vector<float> values;
  values.reserve (scalar.total());
  for (int row = 0; row < scalar.rows; ++row)
    for (int col = 0; col < scalar.cols; ++col)
      if (std::isfinite (scalar.at<float> (row, col)))
        values.push_back (scalar.at<float> (row, col));
  return values;
}

/** 0 without values. Changes their order. */
double
percentile (std::vector<float>& values, double share)
{
  return values.empty() ? 0.0 : quantile (values, share);
}

/** Colours the shares 0 .. 1; NaN is black. */
cv::Mat
colorize (const cv::Mat& shares, int color_map)
{
  cv::Mat levels (shares.size(), CV_8UC1);
  cv::Mat known (shares.size(), CV_8UC1);
  for (int row = 0; row < shares.rows; ++row)
    for (int col = 0; col < shares.cols; ++col) {
      const float share = shares.at<float> (row, col);
      known.at<unsigned char> (row, col) = std::isfinite (share) ? 255 : 0;
      levels.at<unsigned char> (row, col) =
          cv::saturate_cast<unsigned char> (std::isfinite (share) ? 255.0F * share : 0);
    }
  cv::Mat colors;
  inThisThread ([&] { cv::applyColorMap (levels, colors, color_map); });
  cv::Mat picture (shares.size(), CV_8UC3, cv::Scalar::all (0));
  colors.copyTo (picture, known);
  return picture;
}

/** Adds the colour map below the picture with numbers at its two ends. */
cv::Mat
withScaleBar (const cv::Mat& picture,
              int color_map,
              const std::string& low,
              const std::string& high)
{
  cv::Mat result;
  cv::copyMakeBorder (
      picture, result, 0, kBarHeight, 0, 0, cv::BORDER_CONSTANT, cv::Scalar::all (255));
  cv::Mat ramp (12, std::max (1, result.cols - 16), CV_32FC1);
  for (int col = 0; col < ramp.cols; ++col)
    ramp.col (col).setTo (static_cast<float> (col) / static_cast<float> (ramp.cols));
  const cv::Rect place (std::min (8, result.cols - 1), picture.rows + 4, ramp.cols, 12);
  if ((place & cv::Rect (0, 0, result.cols, result.rows)) == place)
    colorize (ramp, color_map).copyTo (result (place));
  const int base = picture.rows + kBarHeight - 5;
  drawText (result, low, {8, base}, 10, cv::Scalar::all (0));
  drawText (result,
            high,
            {result.cols - 8 - textWidth (high, 10), base},
            10,
            cv::Scalar::all (0));
  return result;
}

} // namespace

cv::Mat
scalarPicture (const cv::Mat& scalar, double maximum, const std::string& unit)
{
  CV_Assert (scalar.type() == CV_32FC1);
  double top = maximum;
  if (!(top > 0.0)) {
    std::vector<float> values = finiteValues (scalar);
    top = percentile (values, 0.99);
  }
  if (!(top > 0.0))
    top = 1.0;
  const cv::Mat shares = scalar / top;
  return withScaleBar (colorize (shares, cv::COLORMAP_INFERNO),
                       cv::COLORMAP_INFERNO,
                       "0",
                       shortNumber (top) + " " + unit);
}

cv::Mat
depthPicture (const cv::Mat& depth)
{
  CV_Assert (depth.type() == CV_32FC1);
  cv::Mat inverse (depth.size(), CV_32FC1);
  for (int row = 0; row < depth.rows; ++row)
    for (int col = 0; col < depth.cols; ++col) {
      const float z = depth.at<float> (row, col);
      inverse.at<float> (row, col) = z > 0.0F && std::isfinite (z)
                                         ? 1.0F / z
                                         : std::numeric_limits<float>::quiet_NaN();
    }
  std::vector<float> values = finiteValues (inverse);
  const double far = percentile (values, 0.01);
  const double near = std::max (percentile (values, 0.99), far + 1e-6);
  const cv::Mat shares = (inverse - far) / (near - far);
  return withScaleBar (colorize (shares, cv::COLORMAP_TURBO),
                       cv::COLORMAP_TURBO,
                       shortNumber (1.0 / std::max (far, 1e-6)) + " m",
                       shortNumber (1.0 / near) + " m");
}

} // namespace pcl_msf::io
