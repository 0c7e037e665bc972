// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>

namespace pcl_msf::io {

/** \brief A colour for a label, 0 or more: those near each other differ clearly. BGR */
PCL_MSF_EXPORT cv::Vec3b
labelColor (int label);

/** \brief Does a boundary run between this pixel and its right or lower neighbour?
 * \param labels CV_32SC1 */
PCL_MSF_EXPORT bool
onBoundary (const cv::Mat& labels, int row, int col);

} // namespace pcl_msf::io
