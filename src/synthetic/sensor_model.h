// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/synthetic/synthetic_sequence.h>
#include <synthetic/frame_view.h>

#include <vector>

namespace pcl_msf::synthetic {

/** \brief What is in front of a depth sensor. */
struct SensorInput {
  const ImageViews& views;
  const std::vector<ViewHit>& hits; ///< of the views' pixels
  const cv::Mat& color;             ///< CV_32FC3, 0 .. 255, before the colour's noise
  std::uint64_t device;             ///< tells seeds apart: what a device always does
  std::uint64_t frame;              ///< tells frames and seeds apart
  int threads;
};

/** \brief What a sensor makes of exact depth: CV_32F, metres, changed in place; NaN =
 * no measurement. See Sensor. */
void
applyDepthSensor (Sensor sensor, const SensorInput& input, cv::Mat& depth);

// One each.

void
applyKinect (const SensorInput& input, cv::Mat& depth);

void
applyWhite (const SensorInput& input, cv::Mat& depth);

void
applyRealSense (const SensorInput& input, cv::Mat& depth);

void
applyTimeOfFlight (const SensorInput& input, cv::Mat& depth);

void
applyStereo (const SensorInput& input, cv::Mat& depth);

} // namespace pcl_msf::synthetic
