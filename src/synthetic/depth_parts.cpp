// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/parallel_for.h"
#include <synthetic/depth_parts.h>
#include <synthetic/lattice_noise.h>
#include <synthetic/noise_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::synthetic {
namespace {

constexpr float border_step = 1.5F; ///< pixels of disparity
constexpr double ragged = 4.0;      ///< pixels along which a border stays alike
constexpr int scatter_radius = 2;   ///< pixels
constexpr std::uint64_t fat_key = 0x1f3a5c7e9b2d4f60ULL;
constexpr std::uint64_t scatter_key = 0x7c1e5a3b9d8f2640ULL;

cv::Mat
square (int radius)
{
  return cv::Mat::ones (2 * radius + 1, 2 * radius + 1, CV_8UC1);
}

/** Noise as a number in [0, 1) of even distribution. */
double
evenly (const cv::Mat& noise, int u, int v)
{
  return 0.5 * std::erfc (-noise.at<double> (v, u) / std::sqrt (2.0));
}

} // namespace

cv::Mat
disparityOf (const cv::Mat& depth, double focal_times_baseline)
{
  cv::Mat disparity = cv::Mat::zeros (depth.size(), CV_32FC1);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u)
      if (const float z = depth.at<float> (v, u); z > 0.0F)
        disparity.at<float> (v, u) = static_cast<float> (focal_times_baseline / z);
  return disparity;
}

cv::Mat
hiddenFrom (Side side, const cv::Mat& disparity, int threads)
{
  cv::Mat hidden = cv::Mat::zeros (disparity.size(), CV_8UC1);
  const int last = disparity.cols - 1;
  parallelFor (threads, disparity.rows, 4, [&] (int v) {
    // A point is hidden where one further away from that side appears nearer to it.
    double farthest = -std::numeric_limits<double>::infinity();
    for (int i = 0; i <= last; ++i) {
      const int u = side == Side::Left ? i : last - i;
      const float d = disparity.at<float> (v, u);
      if (!(d > 0.0F))
        continue;
      if (i + d < farthest - 1.0)
        hidden.at<unsigned char> (v, u) = 255;
      farthest = std::max<double> (farthest, i + d);
    }
  });
  return hidden;
}

void
fattenBorders (int most, const SensorInput& input, cv::Mat& disparity)
{
  std::vector<cv::Mat> nearest (most + 1);
  withThreads (input.threads, [&] {
    for (int radius = 1; radius <= most; ++radius)
      cv::dilate (disparity, nearest[radius], square (radius));
  });
  const cv::Mat noise = correlatedNoise (
      disparity.size(), ragged, input.frame ^ fat_key, 0, input.threads);
  parallelFor (input.threads, disparity.rows, 4, [&] (int v) {
    for (int u = 0; u < disparity.cols; ++u) {
      const double share = 0.5 + 0.5 * evenly (noise, u, v);
      const int radius = std::max (1, static_cast<int> (std::lround (share * most)));
      const float near = nearest[radius].at<float> (v, u);
      float& own = disparity.at<float> (v, u);
      if (near - own > border_step)
        own = near;
    }
  });
}

void
scatterBorders (double flying,
                double lost,
                const SensorInput& input,
                cv::Mat& disparity)
{
  cv::Mat low, high;
  withThreads (input.threads, [&] {
    cv::erode (disparity, low, square (scatter_radius));
    cv::dilate (disparity, high, square (scatter_radius));
  });
  const auto noise = [&] (int channel) {
    return correlatedNoise (
        disparity.size(), 1.0, input.frame ^ scatter_key, channel, input.threads);
  };
  const cv::Mat chance = noise (0), place = noise (1);
  parallelFor (input.threads, disparity.rows, 4, [&] (int v) {
    for (int u = 0; u < disparity.cols; ++u) {
      const float near = high.at<float> (v, u), far = low.at<float> (v, u);
      if (!(near - far > border_step))
        continue;
      const double share = evenly (chance, u, v);
      float& own = disparity.at<float> (v, u);
      if (share < flying)
        own = static_cast<float> (far + evenly (place, u, v) * (near - far));
      else if (share > 1.0 - lost)
        own = 0.0F;
    }
  });
}

double
facing (const SensorInput& input, int u, int v)
{
  const ViewHit& hit = input.hits[static_cast<std::size_t> (v) * input.color.cols + u];
  if (hit.part < 0)
    return 0.0;
  const Eigen::Vector3d ray = input.views.row (v).direction (u, v);
  return std::max (0.0, -hit.normal.dot (ray) / ray.norm());
}

bool
isLostBySlant (const SensorInput& input, int u, int v)
{
  const double chance = std::clamp ((0.22 - facing (input, u, v)) / 0.1, 0.0, 1.0);
  return uniformFrom (pixelKey (input.frame, u, v, 0)) < chance;
}

cv::Mat
contrastOf (const SensorInput& input, int window)
{
  cv::Mat contrast;
  withThreads (input.threads, [&] {
    cv::Mat gray, mean, square_mean;
    cv::cvtColor (input.color, gray, cv::COLOR_BGR2GRAY);
    cv::boxFilter (gray, mean, CV_32F, {window, window});
    cv::sqrBoxFilter (gray, square_mean, CV_32F, {window, window});
    cv::sqrt (cv::max (square_mean - mean.mul (mean), 0.0), contrast);
  });
  return contrast;
}

} // namespace pcl_msf::synthetic
