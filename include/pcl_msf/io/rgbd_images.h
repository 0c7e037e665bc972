// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>

#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief One RGB-D picture as RgbdFrame::fromImages takes it. */
struct RgbdImages {
  cv::Mat color;        ///< CV_8UC1 or CV_8UC3 (BGR); empty = geometry only
  cv::Mat depth;        ///< CV_32FC1, metres; 0, NaN, inf or negative = none
  PinholeCamera camera; ///< of both, pixels

  /** \brief What `color` was made of when the file has no bytes but numbers of a range
   * of its own (intensities of ToF cameras, lidars, infrared; colours as floats):
   * CV_32FC1 or CV_32FC3 (BGR), as in the file; empty otherwise. See unifyColors. */
  cv::Mat raw_color{};

  /** \brief What of the file was not used, and why; empty when all was. */
  std::string note{};
};

/** \brief The unit of the frames' raw colours: what stands for full brightness when all
 * of them are brought to one range by pcl_msf::normalizeIntensity. 1 without any. */
double
colorUnit (const std::vector<const RgbdImages*>& frames);

/** \brief Makes `color` anew from `raw_color`: 255 for `unit` and more, CV_8UC3.
 * Nothing happens to a frame without raw colours. \param unit > 0 */
void
setColorUnit (RgbdImages& frame, double unit);

/** \brief Brings frames that are compared to one unit. A reader sees one frame alone
 * and takes that frame's; where maxima differ, brightness would differ with them. */
void
unifyColors (const std::vector<RgbdImages*>& frames);

} // namespace pcl_msf::io
