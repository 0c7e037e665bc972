// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>

#include <string>

// The formats of KITTI 2015: Menze and Geiger, "Object Scene Flow for Autonomous
// Vehicles", CVPR 2015, and its development kit's description.
namespace pcl_msf::io {

/** \brief What a calib_cam_to_cam file says of the left colour camera, number 02. */
struct KittiCamera {
  PinholeCamera camera;
  double baseline{0.0}; ///< to the right colour camera, 03, metres
};

/** \brief \throws IoError */
KittiCamera
readKittiCamera (const std::string& path);

/** \brief Reads disparities: 16-bit PNG / 256 with 0 and 65535 = unknown, or a .pfm.
 * \return CV_32FC1, pixels; not > 0 or not finite = unknown \throws IoError */
cv::Mat
readKittiDisparity (const std::string& path);

/** \brief Reads optical flow: 16-bit PNG, red and green are u and v as 64 u + 2^15,
 * blue 0 = unknown. \return CV_32FC2, pixels, NaN = unknown \throws IoError */
cv::Mat
readKittiFlow (const std::string& path);

} // namespace pcl_msf::io
