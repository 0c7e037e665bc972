// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>

#include <vector>

namespace pcl_msf::visualization {

/** \brief Pictures side by side, row by row, scaled to the first one's size.
 * \param pictures CV_8UC3, at least one \param columns >= 1 \param background BGR
 * \return CV_8UC3 */
PCL_MSF_EXPORT cv::Mat
pictureSheet (const std::vector<cv::Mat>& pictures,
              int columns,
              const cv::Vec3b& background);

} // namespace pcl_msf::visualization
