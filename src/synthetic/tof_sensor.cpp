// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Foix, Alenya and Torras, "Lock-in Time-of-Flight (ToF) Cameras: A Survey", IEEE
// Sensors Journal 2011: wiggling, multipath, mixed pixels, noise by amplitude.
// Fankhauser et al., "Kinect v2 for Mobile Robot Navigation: Evaluation and Modeling",
// ICAR 2015: noise of 1 to 2 mm near by, growing with distance and slant.
#include "core/base/parallel_for.h"
#include <synthetic/depth_parts.h>
#include <synthetic/multipath.h>
#include <synthetic/noise_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::synthetic {
namespace {

constexpr double farthest = 12.0;       ///< metres
constexpr double nearest = 0.2;         ///< metres
constexpr double least_noise = 0.0012;  ///< metres
constexpr double light_noise = 1.25e-4; ///< per metre, on a white surface
constexpr double most_noise = 0.1;      ///< metres; more is no measurement
constexpr double noise_length = 1.0;    ///< pixels: the camera smooths a little
constexpr double wiggle = 0.003;        ///< metres
constexpr double wiggle_period = 0.47;  ///< metres: a quarter of 80 MHz' wave length
constexpr std::uint64_t noise_key = 0x6b2f8d1c4e9a7053ULL;

/** Reflected light, relative to a white surface one metre away. */
double
amplitude (const SensorInput& input, int u, int v, double z)
{
  const cv::Vec3f color = input.color.at<cv::Vec3f> (v, u);
  const double white = std::clamp ((color[0] + color[1] + color[2]) / 765.0, 0.03, 1.0);
  return white * std::max (0.02, facing (input, u, v)) / (z * z);
}

/** At borders a pixel sees both sides: the mean over 3x3 pixels, weighted by light. */
cv::Mat
mixPixels (const SensorInput& input, const cv::Mat& depth)
{
  cv::Mat mixed = depth.clone();
  parallelFor (input.threads, depth.rows, 4, [&] (int v) {
    for (int u = 0; u < depth.cols; ++u) {
      double sum = 0.0, weight = 0.0;
      float low = depth.at<float> (v, u), high = low;
      for (int y = std::max (0, v - 1); y <= std::min (depth.rows - 1, v + 1); ++y)
        for (int x = std::max (0, u - 1); x <= std::min (depth.cols - 1, u + 1); ++x) {
          const float z = depth.at<float> (y, x);
          if (!(z > 0.0F))
            continue;
          const double w = amplitude (input, x, y, z);
          sum += w * z;
          weight += w;
          low = std::min (low, z);
          high = std::max (high, z);
        }
      if (high - low > 0.03F * low)
        mixed.at<float> (v, u) = static_cast<float> (sum / weight);
    }
  });
  return mixed;
}

} // namespace

void
applyTimeOfFlight (const SensorInput& input, cv::Mat& depth)
{
  const cv::Mat mixed = mixPixels (input, depth);
  const cv::Mat bounced = multipathError (input);
  const cv::Mat noise = correlatedNoise (
      depth.size(), noise_length, input.frame ^ noise_key, 0, input.threads);
  parallelFor (input.threads, depth.rows, 4, [&] (int v) {
    for (int u = 0; u < depth.cols; ++u) {
      float& z = depth.at<float> (v, u);
      const double exact = mixed.at<float> (v, u);
      const bool near_enough = z > nearest && exact < farthest;
      z = std::numeric_limits<float>::quiet_NaN();
      if (!near_enough)
        continue;
      const double deviation =
          least_noise + light_noise / amplitude (input, u, v, exact);
      if (deviation > most_noise)
        continue;
      const double stretch = input.views.row (v).direction (u, v).norm();
      const double error =
          wiggle * std::sin (2.0 * M_PI * exact * stretch / wiggle_period) +
          bounced.at<float> (v, u) + deviation * noise.at<double> (v, u);
      z = static_cast<float> (exact + error / stretch);
    }
  });
}

} // namespace pcl_msf::synthetic
