// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/parameters.h>
#include <pcl_msf/rgbd_frame.h>

namespace pcl_msf {

/** \brief The paper's segmentation: Felzenszwalb and Huttenlocher's graph-based one on
 * the depth in metres (section 3.3, 4.1), by cv::ximgproc. CV_32SC1; discarded small
 * segments are -1. */
cv::Mat
segmentByFelzenszwalb (const FrameLevel& level,
                       const SegmentationParameters& parameters,
                       int threads);

/** \brief SLIC superpixels on intensity and inverse depth, by cv::ximgproc. */
cv::Mat
segmentBySlic (const FrameLevel& level, int size, int threads);

} // namespace pcl_msf
