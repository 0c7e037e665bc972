// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

namespace pcl_msf {

/** \brief Standard deviation of the noise of a CV_32FC1 intensity image.
 *
 * From the median absolute response to the mask (1 -2 1)' (1 -2 1), which constant and
 * linear image parts do not excite (Immerkaer, CVIU 1996, with a median in place of his
 * mean, so that texture counts less). */
double
estimateIntensityNoise (const cv::Mat& intensity);

/** \brief Standard deviation of a CV_32FC1 inverse depth image (0 = none).
 *
 * From second differences along rows: inverse depth is affine on a plane, so that they
 * see the noise, and on curved surfaces the error of linear interpolation. */
double
estimateInverseDepthNoise (const cv::Mat& inverse_depth);

} // namespace pcl_msf
