// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/bilinear.h"
#include "core/base/opencv_threads.h"
#include "evaluation/check_images.h"
#include <pcl_msf/evaluation/flow_errors.h>
#include <pcl_msf/evaluation/residuals.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_msf::evaluation {

namespace {

constexpr double kLeastNoise = 1e-5; // 1 / metres; no sensor is better
constexpr float kOneSurface = 1.05f; // largest ratio of depths of one surface

cv::Mat
gray (const char* name, const cv::Mat& color, const cv::Size& size)
{
  if (color.channels() != 3) {
    requireImage (name, color, CV_8UC1, size);
    return color;
  }
  requireImage (name, color, CV_8UC3, size);
  cv::Mat result;
  inThisThread ([&] { cv::cvtColor (color, result, cv::COLOR_BGR2GRAY); });
  return result;
}

bool
isDepth (float z)
{
  return z > 0.0f && std::isfinite (z);
}

float
nearestDepth (const cv::Mat& depth, float u, float v)
{
  const float z = depth.at<float> (cvRound (v), cvRound (u));
  return isDepth (z) ? z : 0.0f;
}

} // namespace

PhotometricResiduals
photometricResiduals (const cv::Mat& flow,
                      const cv::Mat& reference,
                      const cv::Mat& current,
                      const cv::Mat& mask)
{
  requireImage ("flow", flow, CV_32FC2, flow.size());
  requireImage ("mask", mask, CV_8UC1, flow.size());
  const cv::Mat first = gray ("reference", reference, flow.size());
  cv::Mat second, warped, target (flow.size(), CV_32FC2);
  gray ("current", current, flow.size()).convertTo (second, CV_32F);
  for (int y = 0; y < flow.rows; ++y)
    for (int x = 0; x < flow.cols; ++x) {
      const cv::Vec2f f = flow.at<cv::Vec2f> (y, x);
      const bool known = std::isfinite (f[0] + f[1]);
      target.at<cv::Vec2f> (y, x) = cv::Vec2f (x, y) + (known ? f : cv::Vec2f());
    }
  inThisThread ([&] {
    cv::remap (
        second, warped, target, cv::noArray(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  });
  std::vector<double> residuals;
  for (int y = 0; y < flow.rows; ++y)
    for (int x = 0; x < flow.cols; ++x)
      if (mask.at<unsigned char> (y, x) == 255)
        residuals.push_back (
            std::abs (warped.at<float> (y, x) - first.at<unsigned char> (y, x)));
  return {static_cast<long> (residuals.size()), mean (residuals), median (residuals)};
}

float
depthAt (const cv::Mat& depth, float u, float v)
{
  if (!(u > -0.5f && v > -0.5f && u < depth.cols - 0.5f && v < depth.rows - 0.5f))
    return 0.0f;
  const int x = cvFloor (u), y = cvFloor (v);
  if (x < 0 || y < 0 || x + 1 >= depth.cols || y + 1 >= depth.rows)
    return nearestDepth (depth, u, v);
  const float* top = depth.ptr<float> (y) + x;
  const float* low = depth.ptr<float> (y + 1) + x;
  if (!isDepth (top[0]) || !isDepth (top[1]) || !isDepth (low[0]) || !isDepth (low[1]))
    return nearestDepth (depth, u, v);
  const auto [least, most] = std::minmax ({top[0], top[1], low[0], low[1]});
  if (most > kOneSurface * least)
    return nearestDepth (depth, u, v);
  const float a = u - x, b = v - y;
  return 1.0f /
         bilinear (a, b, 1.0f / top[0], 1.0f / top[1], 1.0f / low[0], 1.0f / low[1]);
}

DepthResiduals
depthResiduals (const cv::Mat& points,
                const cv::Mat& displacement,
                const cv::Mat& current_depth,
                const PinholeCamera& camera,
                double inverse_depth_noise,
                const cv::Mat& mask)
{
  requireImage ("points", points, CV_32FC3, mask.size());
  requireImage ("displacement", displacement, CV_32FC3, mask.size());
  requireImage ("current depth", current_depth, CV_32FC1, mask.size());
  requireImage ("mask", mask, CV_8UC1, mask.size());
  std::vector<double> metres, sigmas;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x) {
      cv::Vec3f p = points.at<cv::Vec3f> (y, x);
      const cv::Vec3f d = displacement.at<cv::Vec3f> (y, x);
      if (std::isfinite (d[0] + d[1] + d[2]))
        p += d;
      if (mask.at<unsigned char> (y, x) != 255 || !isDepth (p[2]))
        continue;
      const Eigen::Vector2d pixel = camera.project ({p[0], p[1], p[2]});
      const float z = depthAt (current_depth,
                               static_cast<float> (pixel.x()),
                               static_cast<float> (pixel.y()));
      if (z <= 0.0f)
        continue;
      metres.push_back (std::abs (p[2] - z));
      sigmas.push_back (std::abs (1.0 / p[2] - 1.0 / z) / inverse_depth_noise);
    }
  const double sigma = inverse_depth_noise >= kLeastNoise
                           ? median (std::move (sigmas))
                           : std::numeric_limits<double>::quiet_NaN();
  return {static_cast<long> (metres.size()), mean (metres), median (metres), sigma};
}

} // namespace pcl_msf::evaluation
