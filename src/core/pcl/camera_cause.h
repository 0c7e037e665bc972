// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>

#include <string>

namespace pcl_msf {

/** \brief Why points are not an image of the camera, and the remedy: mirrored or
 * exchanged axes, a rotation, an offset, another camera. What the points themselves
 * don't tell is not guessed: then it says what was tried.
 * \param points CV_32FC3, as from coordinateImage
 * \param camera the one expected; null when any would do */
std::string
causeOfMisfit (const cv::Mat& points, const PinholeCamera* camera);

/** \brief "fx 525, fy 525, cx 319.5, cy 239.5" */
std::string
cameraText (const PinholeCamera& camera);

} // namespace pcl_msf
