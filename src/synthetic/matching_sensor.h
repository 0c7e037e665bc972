// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <synthetic/depth_parts.h>

namespace pcl_msf::synthetic {

/** \brief A sensor that compares windows of two images, or of one and a pattern. */
struct MatchingSensor {
  double focal;    ///< of disparities, pixels
  double baseline; ///< metres
  Side second;     ///< where the second camera, or the projector, is
  double error;    ///< standard deviation of disparity, pixels
  double window;   ///< correlation length of the error, pixels of the image
  double bend;     ///< slow bends: rms, shares of disparity
  double steps;    ///< of disparity, per pixel
  int fattening;   ///< of borders, pixels of the image
  double flying;   ///< share of the pixels at borders that lie between
  double lost;     ///< share of them that give no measurement
  double nearest;  ///< metres
  double least;    ///< disparity, pixels: less is too far away
};

/** \brief Changes exact depth (CV_32FC1, metres) into what the sensor gives.
 * \param factors of the error, CV_32FC1; empty = 1
 * \param unmatched CV_8UC1, 255 = no measurement here; empty = everywhere */
void
applyMatching (const MatchingSensor& sensor,
               const SensorInput& input,
               const cv::Mat& factors,
               const cv::Mat& unmatched,
               cv::Mat& depth);

} // namespace pcl_msf::synthetic
