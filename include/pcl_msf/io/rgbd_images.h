// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>

#include <array>

namespace pcl_msf::io {

/** \brief Where the sensor stood in the world, the VIEWPOINT of a .pcd and the sensor
 * pose of a pcl::PointCloud. Nothing is computed with it: it goes from a frame to the
 * clouds made of it, so that viewers show them in one place. */
struct Viewpoint {
  std::array<float, 3> origin{0, 0, 0};         ///< metres
  std::array<float, 4> orientation{1, 0, 0, 0}; ///< quaternion, w x y z
};

/** \brief One RGB-D picture as RgbdFrame::fromImages takes it. */
struct RgbdImages {
  cv::Mat color;         ///< CV_8UC1 or CV_8UC3 (BGR); empty = geometry only
  cv::Mat depth;         ///< CV_32FC1, metres; 0, NaN, inf or negative = none
  PinholeCamera camera;  ///< of both, pixels
  Viewpoint viewpoint{}; ///< as the cloud's file says; images have none
};

} // namespace pcl_msf::io
