// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/truth_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::io {

namespace {

constexpr float kTolerance = 0.01F;

bool
isInside (const cv::Size& size, double x, double y)
{
  return x >= -0.5 && y >= -0.5 && x < size.width - 0.5 && y < size.height - 0.5;
}

bool
isDepth (float z)
{
  return std::isfinite (z) && z > 0.0F;
}

/** Smallest and largest depth of the pixels around a place; false without any. */
bool
depthRange (const cv::Mat& depth, float x, float y, float& nearest, float& farthest)
{
  nearest = std::numeric_limits<float>::max();
  farthest = 0.0F;
  const auto within = [] (float place, int size) {
    return std::clamp (static_cast<int> (place), 0, size - 1);
  };
  for (const float v : {std::floor (y), std::ceil (y)})
    for (const float u : {std::floor (x), std::ceil (x)}) {
      const int row = within (v, depth.rows), col = within (u, depth.cols);
      const float z = depth.at<float> (row, col);
      if (!isDepth (z))
        continue;
      nearest = std::min (nearest, z);
      farthest = std::max (farthest, z);
    }
  return farthest > 0.0F;
}

} // namespace

cv::Mat
sceneFlowFrom (const cv::Mat& depth,
               const cv::Mat& flow,
               const cv::Mat& later_depth,
               const PinholeCamera& camera,
               const PinholeCamera& later_camera)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cv::Mat result (depth.size(), CV_32FC3, cv::Scalar (nan, nan, nan));
  for (int row = 0; row < depth.rows; ++row)
    for (int col = 0; col < depth.cols; ++col) {
      const float z0 = depth.at<float> (row, col);
      const float z1 = later_depth.at<float> (row, col);
      const cv::Vec2f f = flow.at<cv::Vec2f> (row, col);
      if (!isDepth (z0) || !isDepth (z1) || !std::isfinite (f[0] + f[1]))
        continue;
      const Eigen::Vector3d moved =
          later_camera.backProject (col + double{f[0]}, row + double{f[1]}, z1) -
          camera.backProject (col, row, z0);
      result.at<cv::Vec3f> (row, col) = cv::Vec3f (static_cast<float> (moved.x()),
                                                   static_cast<float> (moved.y()),
                                                   static_cast<float> (moved.z()));
    }
  return result;
}

cv::Mat
seenInBoth (const cv::Mat& flow,
            const cv::Mat& later_depth,
            const cv::Mat& second_depth)
{
  cv::Mat seen (flow.size(), CV_8UC1, cv::Scalar (0));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const cv::Vec2f f = flow.at<cv::Vec2f> (row, col);
      const float x = static_cast<float> (col) + f[0];
      const float y = static_cast<float> (row) + f[1];
      const float z = later_depth.at<float> (row, col);
      float nearest = 0.0F, farthest = 0.0F;
      if (isDepth (z) && isInside (flow.size(), x, y) &&
          depthRange (second_depth, x, y, nearest, farthest) &&
          z >= nearest * (1.0F - kTolerance) && z <= farthest * (1.0F + kTolerance))
        seen.at<unsigned char> (row, col) = 255;
    }
  return seen;
}

cv::Mat
staysInside (const cv::Mat& flow)
{
  cv::Mat stays (flow.size(), CV_8UC1, cv::Scalar (0));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const cv::Vec2f f = flow.at<cv::Vec2f> (row, col);
      if (isInside (flow.size(), col + double{f[0]}, row + double{f[1]}))
        stays.at<unsigned char> (row, col) = 255;
    }
  return stays;
}

} // namespace pcl_msf::io
