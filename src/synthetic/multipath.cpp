// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/parallel_for.h"
#include <synthetic/multipath.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::synthetic {
namespace {

constexpr int side = 8;   ///< of a patch, pixels
constexpr int reach = 10; ///< patches

struct Patch {
  bool known{false};
  Eigen::Vector3d point, normal;
  double area{0.0};       ///< m^2
  double reflection{0.0}; ///< share of light
  double light{0.0};      ///< that reaches it from the camera, relative
};

Patch
patchAt (const SensorInput& input, int u, int v)
{
  const ViewHit& hit = input.hits[static_cast<std::size_t> (v) * input.color.cols + u];
  Patch patch;
  if (hit.part < 0)
    return patch;
  const FrameView& view = input.views.row (v);
  patch.point = hit.point (view.direction (u, v));
  patch.normal = hit.normal;
  const double distance = patch.point.norm();
  const double cosine = std::max (0.1, -patch.normal.dot (patch.point) / distance);
  patch.area = std::pow (side * hit.depth / view.camera().fx, 2) / cosine;
  const cv::Vec3f color = input.color.at<cv::Vec3f> (v, u);
  patch.reflection = std::clamp ((color[0] + color[1] + color[2]) / 765.0, 0.03, 1.0);
  patch.light = cosine / (distance * distance);
  patch.known = true;
  return patch;
}

/** Light that `from` passes on to `to`, relative to what `to` has of its own. */
double
lightBetween (const Patch& from, const Patch& to, double distance2)
{
  const Eigen::Vector3d way = to.point - from.point;
  const double leaves = from.normal.dot (way), meets = -to.normal.dot (way);
  if (leaves <= 0.0 || meets <= 0.0)
    return 0.0;
  const double form =
      leaves * meets * from.area / (M_PI * distance2 * (distance2 + from.area));
  return std::min (1.0, form) * from.reflection * from.light / to.light;
}

} // namespace

cv::Mat
multipathError (const SensorInput& input)
{
  const cv::Size size = input.color.size();
  const cv::Size grid ((size.width + side - 1) / side, (size.height + side - 1) / side);
  std::vector<Patch> patches;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x)
      patches.push_back (patchAt (input,
                                  std::min (side * x + side / 2, size.width - 1),
                                  std::min (side * y + side / 2, size.height - 1)));
  cv::Mat coarse = cv::Mat::zeros (grid, CV_32FC1);
  parallelFor (input.threads, grid.height, 1, [&] (int y) {
    for (int x = 0; x < grid.width; ++x) {
      const Patch& to = patches[y * grid.width + x];
      double sum = 0.0, weight = 1.0;
      for (int j = std::max (0, y - reach); j <= std::min (grid.height - 1, y + reach);
           ++j)
        for (int i = std::max (0, x - reach); i <= std::min (grid.width - 1, x + reach);
             ++i) {
          const Patch& from = patches[j * grid.width + i];
          const double distance2 =
              to.known && from.known ? (to.point - from.point).squaredNorm() : 0.0;
          if (distance2 == 0.0)
            continue;
          const double w = lightBetween (from, to, distance2);
          sum +=
              0.5 * w * (from.point.norm() + std::sqrt (distance2) - to.point.norm());
          weight += w;
        }
      coarse.at<float> (y, x) = static_cast<float> (sum / weight);
    }
  });
  cv::Mat error;
  withThreads (input.threads, [&] {
    cv::resize (coarse, error, {side * grid.width, side * grid.height});
  });
  return error (cv::Rect ({0, 0}, size)).clone();
}

} // namespace pcl_msf::synthetic
