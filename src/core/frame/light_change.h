// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/frame/brightness_change.h"

namespace pcl_msf {

/** \brief Does the same surface look otherwise, beyond a change of exposure? Light,
 * shade and the lens' falloff change brightness slowly over the image, a camera's
 * response does with brightness.
 *
 * True where functions that vary that slowly explain much of what a gain and an offset
 * leave (robust regression): polynomials of the fourth degree over the image, of the
 * second as a factor, and of the third in the intensity. Then absolute intensities tell
 * nothing; see localContrast (). */
bool
lightChanged (const MatchedIntensities& matches,
              const BrightnessChange& exposure,
              const BrightnessTuning& tuning);

/** \brief Means of an image within some pixels around. \param intensity CV_32FC1; may
 * be empty */
cv::Mat
localMeans (const cv::Mat& intensity, int radius);

/** \brief An image less its mean within some pixels around: what stays of it under
 * another light. \param intensity CV_32FC1; may be empty \param mean_share of the mean
 * that stays, in [0, 1] */
cv::Mat
localContrast (const cv::Mat& intensity, int radius, double mean_share = 0.0);

} // namespace pcl_msf
