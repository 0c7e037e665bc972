// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/frame/normals.h"

#include <pcl/features/integral_image_normal.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace pcl_msf {

namespace {

constexpr float kSameSurface = 0.03f; // relative difference of inverse depth per pixel
constexpr float kSteepest = 0.3f;     // relative difference over the window's radius
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

/** Sums of a least-squares plane through a pixel's inverse depth. */
struct SlopeSums {
  float xx{0.0f}, xy{0.0f}, yy{0.0f}, xw{0.0f}, yw{0.0f};

  void
  add (float dx, float dy, float difference)
  {
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
    xw += dx * difference;
    yw += dy * difference;
  }

  Slope
  solve () const
  {
    const float det = xx * yy - xy * xy;
    if (det < 0.5f)
      return {};
    return {(yy * xw - xy * yw) / det, (xx * yw - xy * xw) / det, true};
  }
};

/** Slopes of the inverse depth in a window, from the pixels of the same surface: those
 * that differ little from the centre, and those that differ much but oppositely to the
 * pixel across the centre, as on a floor seen at a grazing angle. */
Slope
slopeAt (const cv::Mat& w, int x, int y, int radius, float tolerance)
{
  const int step = radius > 2 ? 2 : 1; // every second pixel of a wide window will do
  const float center = w.at<float> (y, x);
  const float steepest = kSteepest * center;
  const auto difference = [&] (int u, int v) {
    const bool inside = u >= 0 && u < w.cols && v >= 0 && v < w.rows;
    const float value = inside ? w.at<float> (v, u) : 0.0f;
    return value > 0.0f ? value - center : std::numeric_limits<float>::infinity();
  };
  SlopeSums sums;
  for (int dy = 0; dy <= radius; dy += step)
    for (int dx = dy == 0 ? step : -radius; dx <= radius; dx += step) {
      const float there = difference (x + dx, y + dy);
      const float across = difference (x - dx, y - dy);
      const bool straight = std::abs (there + across) < tolerance &&
                            std::abs (there) < steepest && std::abs (across) < steepest;
      const auto fx = static_cast<float> (dx);
      const auto fy = static_cast<float> (dy);
      if (straight || std::abs (there) < tolerance)
        sums.add (fx, fy, there);
      if (straight || std::abs (across) < tolerance)
        sums.add (-fx, -fy, across);
    }
  return sums.solve();
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

// Flat, so that no copy of the clouds' functions is left that a program's own, with
// another allocator, could replace.
[[gnu::flatten]] cv::Mat
normalsByIntegralImage (const cv::Mat& w, const PinholeCamera& camera)
{
  // Both clouds are made and freed here and keep their size: what frees or enlarges
  // them elsewhere may be compiled with another allocator, see build_compatibility.h.
  pcl::PointCloud<pcl::PointXYZ> cloud (w.cols, w.rows);
  pcl::PointCloud<pcl::Normal> found (w.cols, w.rows);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int y = 0; y < w.rows; ++y)
    for (int x = 0; x < w.cols; ++x) {
      const float value = w.at<float> (y, x);
      const float z = value > 0.0f ? 1.0f / value : nan;
      cloud.at (x, y).getVector3fMap() = camera.backProject (x, y, z).cast<float>();
    }
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.AVERAGE_3D_GRADIENT);
  estimation.setMaxDepthChangeFactor (0.02f);
  estimation.setNormalSmoothingSize (10.0f);
  estimation.setInputCloud (
      pcl::PointCloud<pcl::PointXYZ>::ConstPtr (std::shared_ptr<void>(), &cloud));
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
