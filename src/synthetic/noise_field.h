// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <cstdint>

namespace pcl_msf::synthetic {

/** \brief Tells the random numbers of pixels and channels (0 .. 3) apart. */
std::uint64_t
pixelKey (std::uint64_t key, int u, int v, int channel);

/** \brief Gaussian noise, CV_64FC1, variance 1, with the correlation exp (-(|du| +
 * |dv|) / length) between pixels: that of recorded depth sensors along rows.
 *
 * White noise, each axis filtered by a decaying exponential. \param length pixels; 0 =
 * white noise */
cv::Mat
correlatedNoise (
    const cv::Size& size, double length, std::uint64_t key, int channel, int threads);

/** \brief Smooth bends over a quarter of the image and more, CV_64FC1, rms about 1. */
cv::Mat
slowBends (const cv::Size& size, std::uint64_t key, int threads);

} // namespace pcl_msf::synthetic
