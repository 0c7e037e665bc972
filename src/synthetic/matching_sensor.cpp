// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/parallel_for.h"
#include <synthetic/matching_sensor.h>
#include <synthetic/noise_field.h>

#include <cmath>
#include <limits>

namespace pcl_msf::synthetic {
namespace {

constexpr std::uint64_t error_key = 0x3d6b1f8e5a7c9024ULL;

} // namespace

void
applyMatching (const MatchingSensor& sensor,
               const SensorInput& input,
               const cv::Mat& factors,
               const cv::Mat& unmatched,
               cv::Mat& depth)
{
  const double unit = sensor.focal * sensor.baseline;
  cv::Mat disparity = disparityOf (depth, unit);
  const double in_image = input.views.row (0).camera().fx / sensor.focal;
  const cv::Mat hidden =
      hiddenFrom (sensor.second, in_image * disparity, input.threads);
  fattenBorders (sensor.fattening, input, disparity);
  scatterBorders (sensor.flying, sensor.lost, input, disparity);
  const cv::Mat noise = correlatedNoise (
      depth.size(), sensor.window, input.frame ^ error_key, 0, input.threads);
  const cv::Mat bends = slowBends (depth.size(), input.device, input.threads);
  parallelFor (input.threads, depth.rows, 4, [&] (int v) {
    for (int u = 0; u < depth.cols; ++u) {
      float& z = depth.at<float> (v, u);
      z = std::numeric_limits<float>::quiet_NaN();
      const double exact = disparity.at<float> (v, u);
      if (!(exact > 0.0) || exact * sensor.nearest > unit ||
          hidden.at<unsigned char> (v, u) != 0 ||
          (!unmatched.empty() && unmatched.at<unsigned char> (v, u) != 0) ||
          isLostBySlant (input, u, v))
        continue;
      const double factor = factors.empty() ? 1.0 : factors.at<float> (v, u);
      const double measured = exact * (1.0 + sensor.bend * bends.at<double> (v, u)) +
                              factor * sensor.error * noise.at<double> (v, u);
      const double rounded = std::round (measured * sensor.steps) / sensor.steps;
      if (rounded >= sensor.least)
        z = static_cast<float> (unit / rounded);
    }
  });
}

} // namespace pcl_msf::synthetic
