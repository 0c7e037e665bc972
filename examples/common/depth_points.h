// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/rgbd_images.h>

namespace pcl_msf::tool {

/** \brief Points of a depth image. \return CV_32FC3, metres, NaN = no depth */
cv::Mat
pointsOf (const io::RgbdImages& images);

} // namespace pcl_msf::tool
