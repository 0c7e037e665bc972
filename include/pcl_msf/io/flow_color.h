// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>

namespace pcl_msf::io {

/** \brief Colours an optical flow as the Middlebury benchmark does (Baker et al., "A
 * Database and Evaluation Methodology for Optical Flow", IJCV 2011).
 *
 * The direction chooses the hue on a wheel of 55 colours, the length over `maximum` the
 * saturation: no motion is white, `maximum` is the full hue, longer is darker.
 * \param flow CV_32FC2, pixels; NaN or inf = unknown, which is black
 * \param maximum pixels that are fully saturated; <= 0 takes the length that 99 % of
 * the known flow stays within, so that a few outliers do not bleach the rest
 * \return CV_8UC3, BGR */
PCL_MSF_EXPORT cv::Mat
flowColors (const cv::Mat& flow, double maximum = 0.0);

/** \brief The length that the given share of the known flow stays within, pixels; 0
 * when nothing is known. \param share 0 .. 1; 1 = the longest vector */
PCL_MSF_EXPORT double
flowLength (const cv::Mat& flow, double share);

/** \brief The wheel itself as a legend, `size` x `size` pixels, white outside. */
PCL_MSF_EXPORT cv::Mat
flowWheel (int size);

} // namespace pcl_msf::io
