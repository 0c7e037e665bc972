// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <synthetic/sensor_model.h>

namespace pcl_msf::synthetic {

// What several depth sensors do. Disparity is CV_32FC1, pixels, 0 = none.

/** \brief Disparity of depth (metres). */
cv::Mat
disparityOf (const cv::Mat& depth, double focal_times_baseline);

/** \brief From where a second camera, or a light, looks. */
enum class Side { Left, Right };

/** \brief What the second camera does not see: CV_8UC1, 255 = hidden. \param disparity
 * in pixels of the image */
cv::Mat
hiddenFrom (Side side, const cv::Mat& disparity, int threads);

/** \brief Matching over a window shows what is nearer too wide, here by half of `most`
 * pixels to all of it. A border is a step of 1.5 pixels of disparity. */
void
fattenBorders (int most, const SensorInput& input, cv::Mat& disparity);

/** \brief A share of the pixels up to two away from a border gets a disparity between
 * those of its two sides, another none. */
void
scatterBorders (double flying,
                double lost,
                const SensorInput& input,
                cv::Mat& disparity);

/** \brief Cosine between a surface and the ray that sees it; 0 where there is none. */
double
facing (const SensorInput& input, int u, int v);

/** \brief Is a surface so slanted (80 deg) that chance gives no measurement? */
bool
isLostBySlant (const SensorInput& input, int u, int v);

/** \brief Standard deviation of brightness around each pixel, CV_32FC1, of 255.
 * \param window side, pixels */
cv::Mat
contrastOf (const SensorInput& input, int window);

} // namespace pcl_msf::synthetic
