// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>

namespace pcl_msf::io {

/** \brief Displacement of points whose pixels and depths are known in both frames.
 *
 * \param depth CV_32FC1, metres, of the first frame \param flow CV_32FC2, pixels
 * \param later_depth CV_32FC1, metres: depth in the second frame's camera of the point
 * seen at each pixel of the first
 * \return CV_32FC3, metres, later minus earlier camera coordinates; NaN = unknown */
cv::Mat
sceneFlowFrom (const cv::Mat& depth,
               const cv::Mat& flow,
               const cv::Mat& later_depth,
               const PinholeCamera& camera,
               const PinholeCamera& later_camera);

/** \brief Which points are seen in the second frame, too: their pixel lies in the image
 * and their depth, within 1 %, between those of the pixels around it (up to four).
 *
 * \param flow CV_32FC2, pixels \param later_depth CV_32FC1 as in sceneFlowFrom
 * \param second_depth CV_32FC1, metres, of the second frame at its own pixels
 * \return CV_8UC1, 255 = seen; 0 where anything is unknown */
cv::Mat
seenInBoth (const cv::Mat& flow,
            const cv::Mat& later_depth,
            const cv::Mat& second_depth);

/** \brief Which points stay in the image. \return CV_8UC1, 255 = stays */
cv::Mat
staysInside (const cv::Mat& flow);

} // namespace pcl_msf::io
