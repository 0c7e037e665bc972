// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>

#include <array>
#include <optional>
#include <string>

// The formats of the Middlebury stereo data sets: Scharstein and Szeliski,
// "High-Accuracy Stereo Depth Maps Using Structured Light", CVPR 2003 (2003),
// Scharstein et al., "High-Resolution Stereo Datasets with Subpixel-Accurate Ground
// Truth", GCPR 2014 (2014, 2021), and their descriptions on the web.
namespace pcl_msf::io {

/** \brief A rectified pair with disparities of both views. */
struct MiddleburyPair {
  std::array<std::string, 2> color;      ///< left, right
  std::array<std::string, 2> disparity;  ///< left, right
  std::array<PinholeCamera, 2> camera;   ///< left, right
  double baseline{0.1};                  ///< metres
  double offset{0.0};                    ///< cx of the right minus that of the left
  std::optional<double> disparity_scale; ///< grey levels a pixel; none = .pfm, pixels
};

/** \brief Does the folder hold the left image and disparity of either layout? */
bool
isMiddlebury (const std::string& folder);

/** \brief Finds the files and the cameras. The data of 2003 come without cameras; there
 * a focal length of 10/9 of the width, the principal point in the centre and a baseline
 * of 0.1 m are made up, and grey levels are 4, 2 or 1 a pixel, for images of up to 600,
 * of up to 1200, and of more columns. \throws IoError */
MiddleburyPair
findMiddlebury (const std::string& folder);

/** \brief Disparities of one view (0 left, 1 right). \return CV_32FC1, pixels, NaN =
 * unknown \throws IoError */
cv::Mat
readMiddleburyDisparity (const MiddleburyPair& pair, std::size_t view);

} // namespace pcl_msf::io
