// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/scene_flow.h>

namespace pcl_msf::visualization {

/** The two tints of an overlay, BGR: far apart for colour-blind eyes, too. */
const cv::Vec3b kReferenceTint (30, 120, 240);
const cv::Vec3b kCurrentTint (200, 110, 20);
const cv::Vec3b kUnknownColor (150, 150, 150);

/** \brief An image as BGR; plain grey when it is empty. */
cv::Mat
ownColors (const cv::Mat& image, const cv::Size& size);

/** \brief One tint, its lightness following the image. */
cv::Mat
tintedColors (const cv::Mat& image, const cv::Size& size, const cv::Vec3b& tint);

/** \brief Values as colours of a map; NaN is grey. \param values CV_32FC1 */
cv::Mat
mappedColors (const cv::Mat& values, double maximum, int color_map);

/** \brief Value that a share of the finite values stays within; 0 without any. */
double
percentile (const cv::Mat& values, double share);

/** \brief Lengths of vectors. \param vectors CV_32FC3 \return CV_32FC1 */
cv::Mat
lengths (const cv::Mat& vectors);

} // namespace pcl_msf::visualization
