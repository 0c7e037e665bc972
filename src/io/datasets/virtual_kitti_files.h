// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <string>

// The formats that Virtual KITTI 1.3.1 (Gaidon et al., "Virtual Worlds as Proxy for
// Multi-Object Tracking Analysis", CVPR 2016) and 2 (Cabon et al., "Virtual KITTI 2",
// 2020) share, after the descriptions on their web pages.
namespace pcl_msf::io {

/** \brief Reads a 16-bit depth image in centimetres. \return CV_32FC1, metres; 0 where
 * it is 65535, the far plane (sky) \throws IoError */
cv::Mat
readVirtualKittiDepth (const std::string& path);

/** \brief Reads optical flow: red is u, green v as (2 c / 65535 - 1) (side - 1), where
 * side is the image's width and height; blue 0 = unknown.
 * \return CV_32FC2, pixels; NaN = unknown \throws IoError */
cv::Mat
readVirtualKittiFlow (const std::string& path);

/** \brief Reads scene flow: red, green, blue are x, y, z as 10 (2 c / 65535 - 1),
 * position in the other frame's camera minus that in this one's.
 * \return CV_32FC3, metres; NaN where a component is cut off at 10 m \throws IoError */
cv::Mat
readVirtualKittiSceneFlow (const std::string& path);

/** \brief The path in another release archive, all of which repeat the same folders:
 * replaces `part` at the end of the folder `vkitti_VERSION_part` that the path goes
 * through. \return empty when it goes through none */
std::string
inOtherArchive (const std::string& path,
                const std::string& part,
                const std::string& other);

} // namespace pcl_msf::io
