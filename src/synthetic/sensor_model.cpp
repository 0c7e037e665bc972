// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include <synthetic/sensor_model.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::synthetic {
namespace {

constexpr double focal_times_baseline = 580.0 * 0.075; ///< pixels times metres
constexpr double disparity_noise = 0.06;               ///< pixels
constexpr double disparity_steps = 8.0;                ///< per pixel
constexpr double nearest = 0.4;                        ///< metres
constexpr double color_noise = 2.5;                    ///< of 255

std::uint64_t
pixelKey (std::uint64_t key, int u, int v, int channel)
{
  return mixed (key) + 4 * (static_cast<std::uint64_t> (v) * 65536 + u) + channel;
}

/** Marks what the projector, to the left of the camera, cannot light. Its columns in a
 * row's order: a surface point is hidden when one further right appears left of it. */
void
shadowRow (const float* depth, int width, double scale, std::vector<char>& dark)
{
  double rightmost = -std::numeric_limits<double>::infinity();
  for (int u = 0; u < width; ++u) {
    dark[u] = 0;
    if (!(depth[u] > 0.0f))
      continue;
    const double column = u + scale * focal_times_baseline / depth[u];
    dark[u] = column < rightmost - 1.0;
    rightmost = std::max (rightmost, column);
  }
}

/** Largest difference of disparity to the four neighbours, pixels. */
double
disparityStep (const cv::Mat& depth, int u, int v)
{
  const double here = focal_times_baseline / depth.at<float> (v, u);
  double largest = 0.0;
  for (const cv::Point step : {cv::Point (1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
    const int x = std::clamp (u + step.x, 0, depth.cols - 1);
    const int y = std::clamp (v + step.y, 0, depth.rows - 1);
    const double there = focal_times_baseline / depth.at<float> (y, x);
    if (there == there)
      largest = std::max (largest, std::abs (here - there));
  }
  return largest;
}

/** Chance that a pixel gives no measurement. */
double
lossAt (
    const cv::Mat& depth, const ViewHit& hit, const Eigen::Vector3d& ray, int u, int v)
{
  const double facing = -hit.normal.dot (ray) / ray.norm();
  const double grazing = std::clamp ((0.22 - facing) / 0.1, 0.0, 1.0);
  const double edge = disparityStep (depth, u, v) > 1.5 ? 0.6 : 0.0;
  return std::max (grazing, edge);
}

} // namespace

void
applyKinectDepth (const FrameView& view,
                  const std::vector<ViewHit>& hits,
                  std::uint64_t key,
                  int threads,
                  cv::Mat& depth)
{
  const cv::Mat exact = depth.clone();
  const double scale = view.camera().fx / 580.0;
  parallelFor (threads, depth.rows, 4, [&] (int v) {
    std::vector<char> dark (depth.cols);
    shadowRow (exact.ptr<float> (v), depth.cols, scale, dark);
    auto* row = depth.ptr<float> (v);
    for (int u = 0; u < depth.cols; ++u) {
      const double z = row[u];
      row[u] = std::numeric_limits<float>::quiet_NaN();
      const ViewHit& hit = hits[static_cast<std::size_t> (v) * depth.cols + u];
      if (!(z >= nearest) || dark[u] ||
          uniformFrom (pixelKey (key, u, v, 0)) <
              lossAt (exact, hit, view.direction (u, v), u, v))
        continue;
      const double disparity = focal_times_baseline / z +
                               disparity_noise * normalFrom (pixelKey (key, u, v, 1));
      const double rounded = std::round (disparity * disparity_steps) / disparity_steps;
      if (rounded >= 1.0)
        row[u] = static_cast<float> (focal_times_baseline / rounded);
    }
  });
}

void
applyKinectColor (std::uint64_t key, int threads, cv::Mat& color)
{
  const double gain = 1.0 + 0.03 * (2.0 * uniformFrom (mixed (key) + 1) - 1.0);
  const double cx = 0.5 * (color.cols - 1), cy = 0.5 * (color.rows - 1);
  parallelFor (threads, color.rows, 4, [&] (int v) {
    auto* row = color.ptr<cv::Vec3f> (v);
    for (int u = 0; u < color.cols; ++u) {
      const double x = u - cx, y = v - cy;
      const double corner = (x * x + y * y) / (cx * cx + cy * cy);
      const double bright = gain * (1.0 - 0.12 * corner);
      for (int c = 0; c < 3; ++c)
        row[u][c] = static_cast<float> (
            bright * row[u][c] +
            color_noise * normalFrom (pixelKey (key ^ 0x5bd1e995ULL, u, v, c)));
    }
  });
}

} // namespace pcl_msf::synthetic
