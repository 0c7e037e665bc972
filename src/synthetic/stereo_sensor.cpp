// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Scharstein and Szeliski, "A Taxonomy and Evaluation of Dense Two-Frame Stereo
// Correspondence Algorithms", IJCV 2002: windows fatten what is nearer, and err where
// there is no texture.
#include <synthetic/matching_sensor.h>

namespace pcl_msf::synthetic {
namespace {

constexpr int window = 9;              ///< pixels
constexpr double good_contrast = 12.0; ///< of 255
constexpr double worst = 4.0;          ///< factor of the error without any contrast

} // namespace

void
applyStereo (const SensorInput& input, cv::Mat& depth)
{
  MatchingSensor sensor{};
  sensor.focal = 580.0;
  sensor.baseline = 0.2;
  sensor.second = Side::Right;
  sensor.error = 0.15;
  sensor.window = 4.5;
  sensor.bend = 0.002;
  sensor.steps = 16.0;
  sensor.fattening = 5;
  sensor.flying = 0.3;
  sensor.lost = 0.1;
  sensor.nearest = 0.45;
  sensor.least = 0.5;
  const cv::Mat factors = cv::min (
      cv::max (good_contrast / cv::max (contrastOf (input, window), 0.1), 1.0), worst);
  applyMatching (sensor, input, factors, {}, depth);
}

} // namespace pcl_msf::synthetic
