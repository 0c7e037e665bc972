// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/normals.h"

#include <pcl/features/integral_image_normal.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr float kSameSurface = 0.03f; // relative difference of inverse depth per pixel
constexpr double kNormalError = 0.08; // radians aimed at
constexpr int kMaxRadius = 4;         // even, as the step in wide windows is two

/** Half width of the window in which slopes reach the aimed accuracy: the slope over a
 * (2r+1)^2 window has standard deviation sigma / sqrt (sum of x^2). */
int
slopeRadius (double focal, double noise, double typical_inverse_depth)
{
  for (int r = 1; r < kMaxRadius; r *= 2) {
    const double side = 2.0 * r + 1.0;
    const double sum_of_squares = side * r * (r + 1.0) * side / 3.0;
    if (focal * noise / (typical_inverse_depth * std::sqrt (sum_of_squares)) <
        kNormalError)
      return r;
  }
  return kMaxRadius;
}

struct Slope {
  float du{0.0f};
  float dv{0.0f};
  bool known{false};
};

/** Slopes of the inverse depth in the window, from the pixels of the same surface taken
 * in pairs opposite each other, else against the centre. */
Slope
slopeAt (const cv::Mat& w, int x, int y, int radius, float tolerance)
{
  const int step = radius > 2 ? 2 : 1; // every second pixel of a wide window will do
  const float center = w.at<float> (y, x);
  float xx = 0.0f;
  float xy = 0.0f;
  float yy = 0.0f;
  float xw = 0.0f;
  float yw = 0.0f;
  for (int dy = -radius; dy <= radius; dy += step) {
    const int v = y + dy;
    if (v < 0 || v >= w.rows)
      continue;
    const float* row = w.ptr<float> (v);
    for (int dx = -radius; dx <= radius; dx += step) {
      const int u = x + dx;
      if (u < 0 || u >= w.cols || row[u] <= 0.0f)
        continue;
      const float d = row[u] - center;
      if (std::abs (d) > tolerance)
        continue;
      const auto fx = static_cast<float> (dx);
      const auto fy = static_cast<float> (dy);
      xx += fx * fx;
      xy += fx * fy;
      yy += fy * fy;
      xw += fx * d;
      yw += fy * d;
    }
  }
  const float det = xx * yy - xy * xy;
  if (det < 0.5f)
    return {};
  return {(yy * xw - xy * yw) / det, (xx * yw - xy * xw) / det, true};
}

float
medianInverseDepth (const cv::Mat& w)
{
  std::vector<float> values;
  for (int y = 0; y < w.rows; y += 8)
    for (int x = 0; x < w.cols; x += 8)
      if (w.at<float> (y, x) > 0.0f)
        values.push_back (w.at<float> (y, x));
  if (values.empty())
    return 1.0f;
  std::nth_element (values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

} // namespace

cv::Mat
normalsByCentralDifferences (const cv::Mat& w,
                             const PinholeCamera& camera,
                             double noise)
{
  cv::Mat normals = cv::Mat::zeros (w.size(), CV_32FC3);
  const int radius = slopeRadius (camera.fx, noise, medianInverseDepth (w));
  for (int y = 0; y < w.rows; ++y)
    for (int x = 0; x < w.cols; ++x) {
      const float center = w.at<float> (y, x);
      if (center <= 0.0f)
        continue;
      const float tolerance =
          std::max (4.0f * static_cast<float> (noise), kSameSurface * center);
      const Slope s = slopeAt (w, x, y, radius, tolerance);
      if (!s.known)
        continue;
      cv::Vec3f n (static_cast<float> (camera.fx) * s.du,
                   static_cast<float> (camera.fy) * s.dv,
                   center - s.du * static_cast<float> (x - camera.cx) -
                       s.dv * static_cast<float> (y - camera.cy));
      const float length = std::sqrt (n.dot (n));
      if (length > 0.0f)
        normals.at<cv::Vec3f> (y, x) = n * (-1.0f / length);
    }
  return normals;
}

cv::Mat
normalsByIntegralImage (const cv::Mat& w, const PinholeCamera& camera)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (
      new pcl::PointCloud<pcl::PointXYZ> (w.cols, w.rows));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int y = 0; y < w.rows; ++y)
    for (int x = 0; x < w.cols; ++x) {
      const float value = w.at<float> (y, x);
      const float z = value > 0.0f ? 1.0f / value : nan;
      cloud->at (x, y).getVector3fMap() = camera.backProject (x, y, z).cast<float>();
    }
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.AVERAGE_3D_GRADIENT);
  estimation.setMaxDepthChangeFactor (0.02f);
  estimation.setNormalSmoothingSize (10.0f);
  estimation.setInputCloud (cloud);
  pcl::PointCloud<pcl::Normal> found;
  estimation.compute (found);
  cv::Mat normals = cv::Mat::zeros (w.size(), CV_32FC3);
  for (int y = 0; y < w.rows; ++y)
    for (int x = 0; x < w.cols; ++x) {
      const pcl::Normal& n = found.at (x, y);
      if (std::isfinite (n.normal_x))
        normals.at<cv::Vec3f> (y, x) = {n.normal_x, n.normal_y, n.normal_z};
    }
  return normals;
}

cv::Mat
halveNormals (const cv::Mat& normals)
{
  cv::Mat result ((normals.rows + 1) / 2, (normals.cols + 1) / 2, CV_32FC3);
  for (int y = 0; y < result.rows; ++y)
    for (int x = 0; x < result.cols; ++x)
      result.at<cv::Vec3f> (y, x) = normals.at<cv::Vec3f> (2 * y, 2 * x);
  return result;
}

} // namespace pcl_msf
