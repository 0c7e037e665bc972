// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/rigid_pose.h>

#include <string>

namespace pcl_msf {
namespace synthetic {

// Each throws IoError naming the file when it cannot be written.

/** \brief A text file. */
void
writeText (const std::string& file, const std::string& text);

/** \brief An image in the format of its name. */
void
writeImage (const std::string& file, const cv::Mat& image);

/** \brief Middlebury `.flo` of a CV_32FC2; what is not finite becomes 1e10. */
void
writeFlo (const std::string& file, const cv::Mat& flow);

/** \brief Colour `.pfm` of a CV_32FC3, channels in their order, rows bottom-up. */
void
writePfm (const std::string& file, const cv::Mat& vectors);

/** \brief Sintel's `.dpt` of a CV_32FC1; no measurement becomes 0. */
void
writeDpt (const std::string& file, const cv::Mat& depth);

/** \brief Sintel's `.cam`: intrinsic 3x3 and extrinsic 3x4, double. */
void
writeCam (const std::string& file,
          const PinholeCamera& camera,
          const RigidPose& camera_from_world);

} // namespace synthetic
} // namespace pcl_msf
