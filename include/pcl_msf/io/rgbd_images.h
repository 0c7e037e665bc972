// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>

namespace pcl_msf::io {

/** \brief One RGB-D picture as RgbdFrame::fromImages takes it. */
struct RgbdImages {
  cv::Mat color;        ///< CV_8UC1 or CV_8UC3 (BGR); empty = geometry only
  cv::Mat depth;        ///< CV_32FC1, metres; 0, NaN, inf or negative = none
  PinholeCamera camera; ///< of both, pixels
};

} // namespace pcl_msf::io
