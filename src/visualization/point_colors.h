// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/scene_flow.h>
#include <pcl_msf/visualization/scene.h>

#include <string>

namespace pcl_msf::visualization {

/** The two tints of an overlay, BGR: far apart for colour-blind eyes, too. */
const cv::Vec3b kReferenceTint (30, 120, 240);
const cv::Vec3b kCurrentTint (200, 110, 20);
const cv::Vec3b kUnknownColor (150, 150, 150);

/** \brief A cloud's colours, BGR: the image, or the shape lit from the sensor when it
 * is empty. \param points CV_32FC3, organized */
cv::Mat
ownColors (const cv::Mat& image, const cv::Mat& points);

/** \brief One tint, its lightness following the cloud's own colours. */
cv::Mat
tintedColors (const cv::Mat& image, const cv::Mat& points, const cv::Vec3b& tint);

/** \brief A colour for a label, light enough to be told from its neighbours. */
cv::Vec3b
lightLabelColor (int label);

/** \brief Values as colours of a map; NaN is grey. \param values CV_32FC1 */
cv::Mat
mappedColors (const cv::Mat& values, double maximum, int color_map);

/** \brief Value that a share of the finite values stays within; 0 without any. */
double
percentile (const cv::Mat& values, double share);

/** \brief End of a colour scale: `maximum`, or when it is 0 a round number that most
 * of the values stay within; 1 without any. */
ColorScale
colorScale (const cv::Mat& values, double maximum, const std::string& title, int map);

/** \brief Values of points that both frames see; the others become NaN.
 * \param visibility see Visibility */
cv::Mat
whereVisible (const cv::Mat& values, const cv::Mat& visibility);

/** \brief Lengths of vectors. \param vectors CV_32FC3 \return CV_32FC1 */
cv::Mat
lengths (const cv::Mat& vectors);

} // namespace pcl_msf::visualization
