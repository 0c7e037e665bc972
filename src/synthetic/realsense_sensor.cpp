// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Keselman et al., "Intel RealSense Stereoscopic Depth Cameras", CVPR workshops 2017:
// matching over windows, errors of disparity of 0.05 to 0.1 pixels, steps of 1/32.
#include <synthetic/matching_sensor.h>
#include <synthetic/noise_field.h>

namespace pcl_msf::synthetic {
namespace {

constexpr int window = 9;            ///< pixels
constexpr float faint = 2.5F;        ///< contrast that does not mark a surface, of 255
constexpr double hole_length = 6.0;  ///< pixels
constexpr double marked_above = 0.3; ///< sigma: the projector's dots mark four in ten
constexpr std::uint64_t hole_key = 0x2e9d4c7b6a185f03ULL;

} // namespace

void
applyRealSense (const SensorInput& input, cv::Mat& depth)
{
  MatchingSensor sensor{};
  sensor.focal = 600.0;
  sensor.baseline = 0.05;
  sensor.second = Side::Right;
  sensor.error = 0.08;
  sensor.window = 8.5;
  sensor.bend = 0.004;
  sensor.steps = 32.0;
  sensor.fattening = 5;
  sensor.flying = 0.2;
  sensor.lost = 0.2;
  sensor.nearest = 0.2;
  sensor.least = 1.0;
  const cv::Mat light = correlatedNoise (
      depth.size(), hole_length, input.frame ^ hole_key, 0, input.threads);
  const cv::Mat unmatched =
      (contrastOf (input, window) < faint) & (light < marked_above);
  applyMatching (sensor, input, {}, unmatched, depth);
}

} // namespace pcl_msf::synthetic
