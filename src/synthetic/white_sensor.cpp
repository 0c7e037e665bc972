// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include <synthetic/lattice_noise.h>
#include <synthetic/noise_field.h>
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

/** Probability that a pixel gives no measurement. */
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
applyWhite (const SensorInput& input, cv::Mat& depth)
{
  const cv::Mat exact = depth.clone();
  const double scale = input.views.row (0).camera().fx / 580.0;
  parallelFor (input.threads, depth.rows, 4, [&] (int v) {
    std::vector<char> dark (depth.cols);
    shadowRow (exact.ptr<float> (v), depth.cols, scale, dark);
    auto* row = depth.ptr<float> (v);
    for (int u = 0; u < depth.cols; ++u) {
      const double z = row[u];
      row[u] = std::numeric_limits<float>::quiet_NaN();
      const ViewHit& hit = input.hits[static_cast<std::size_t> (v) * depth.cols + u];
      if (!(z >= nearest) || dark[u] ||
          uniformFrom (pixelKey (input.frame, u, v, 0)) <
              lossAt (exact, hit, input.views.row (v).direction (u, v), u, v))
        continue;
      const double disparity =
          focal_times_baseline / z +
          disparity_noise * normalFrom (pixelKey (input.frame, u, v, 1));
      const double rounded = std::round (disparity * disparity_steps) / disparity_steps;
      if (rounded >= 1.0)
        row[u] = static_cast<float> (focal_times_baseline / rounded);
    }
  });
}

} // namespace pcl_msf::synthetic
