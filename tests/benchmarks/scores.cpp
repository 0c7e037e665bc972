// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "scores.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl_msf::benchmark {

namespace {

cv::Mat
gray (const cv::Mat& color)
{
  cv::Mat result = color;
  if (color.channels() == 3)
    cv::cvtColor (color, result, cv::COLOR_BGR2GRAY);
  return result;
}

Errors
summarize (const std::vector<double>& values)
{
  const double sum = std::accumulate (values.begin(), values.end(), 0.0);
  return {sum / static_cast<double> (values.size()), median (values)};
}

bool
counts (const cv::Mat& visible, const cv::Mat& depth, int y, int x)
{
  return depth.at<float> (y, x) > 0.0f &&
         (visible.empty() || visible.at<unsigned char> (y, x) == 255);
}

cv::Vec2f
orZero (const cv::Vec2f& flow)
{
  return std::isfinite (flow[0] + flow[1]) ? flow : cv::Vec2f (0.0f, 0.0f);
}

} // namespace

double
median (std::vector<double> values)
{
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t> (values.size() / 2);
  std::nth_element (values.begin(), middle, values.end());
  return *middle;
}

Errors
endPointErrors (const cv::Mat& flow,
                const cv::Mat& truth,
                const cv::Mat& visible,
                const cv::Mat& depth)
{
  std::vector<double> errors;
  for (int y = 0; y < truth.rows; ++y)
    for (int x = 0; x < truth.cols; ++x) {
      const cv::Vec2f t = truth.at<cv::Vec2f> (y, x);
      if (std::isfinite (t[0] + t[1]) && counts (visible, depth, y, x))
        errors.push_back (cv::norm (orZero (flow.at<cv::Vec2f> (y, x)) - t));
    }
  return summarize (errors);
}

double
meanError3d (const cv::Mat& displacement,
             const cv::Mat& truth,
             const cv::Mat& visible,
             const cv::Mat& depth)
{
  std::vector<double> errors;
  for (int y = 0; y < truth.rows; ++y)
    for (int x = 0; x < truth.cols; ++x) {
      const cv::Vec3f t = truth.at<cv::Vec3f> (y, x);
      cv::Vec3f d = displacement.at<cv::Vec3f> (y, x);
      if (!std::isfinite (d[0] + d[1] + d[2]))
        d = {0.0f, 0.0f, 0.0f};
      if (std::isfinite (t[0] + t[1] + t[2]) && counts (visible, depth, y, x))
        errors.push_back (1e3 * cv::norm (d - t));
    }
  return summarize (errors).mean;
}

Errors
brightnessResiduals (const cv::Mat& flow,
                     const io::RgbdImages& reference,
                     const io::RgbdImages& current,
                     const cv::Mat& mask)
{
  const cv::Mat first = gray (reference.color);
  const cv::Mat second = gray (current.color);
  cv::Mat map (flow.size(), CV_32FC2);
  for (int y = 0; y < flow.rows; ++y)
    for (int x = 0; x < flow.cols; ++x)
      map.at<cv::Vec2f> (y, x) = orZero (flow.at<cv::Vec2f> (y, x)) + cv::Vec2f (x, y);
  cv::Mat exact, warped;
  second.convertTo (exact, CV_32F);
  cv::remap (exact, warped, map, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  std::vector<double> residuals;
  for (int y = 0; y < flow.rows; ++y)
    for (int x = 0; x < flow.cols; ++x)
      if (counts (mask, reference.depth, y, x))
        residuals.push_back (
            std::abs (warped.at<float> (y, x) - first.at<unsigned char> (y, x)));
  return summarize (residuals);
}

cv::Mat
disFlow (const io::RgbdImages& reference, const io::RgbdImages& current)
{
  cv::Mat flow;
  if (reference.color.empty())
    return flow;
  cv::DISOpticalFlow::create (cv::DISOpticalFlow::PRESET_MEDIUM)
      ->calc (gray (reference.color), gray (current.color), flow);
  return flow;
}

} // namespace pcl_msf::benchmark
