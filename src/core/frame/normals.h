// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/instruction_set.h"
#include "core/base/tuning/frame_tuning.h"
#include <pcl_msf/parameters.h>
#include <pcl_msf/pinhole_camera.h>

namespace pcl_msf {

/** \brief Normals of an inverse depth image (Eq. 9): CV_32FC3, unit, towards the
 * camera; 0 0 0 where there is no depth or no neighbour on the same surface.
 *
 * The cross product of the tangents along x and y; with W the inverse depth and W_u,
 * W_v its differences, it is parallel to (fx W_u, fy W_v, W - W_u (u - cx) - W_v (v -
 * cy)). Differences are central, over a few pixels on both sides (more where
 * the sensor is noisy), and stay on the pixel's own surface. All instruction sets give
 * the same bits. */
cv::Mat
normalsByCentralDifferences (const cv::Mat& inverse_depth,
                             const PinholeCamera& camera,
                             double noise,
                             const NormalTuning& tuning,
                             InstructionSet set = chosenInstructionSet());

/** \brief The same by pcl::IntegralImageNormalEstimation. */
cv::Mat
normalsByIntegralImage (const cv::Mat& inverse_depth, const PinholeCamera& camera);

/** \brief Every second normal in both directions. */
cv::Mat
halveNormals (const cv::Mat& normals);

} // namespace pcl_msf
