// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/instruction_set.h"
#include "core/base/tuning/frame_tuning.h"

namespace pcl_msf {

/** \brief Inverse depth (CV_32FC1, 1 / metres, 0 = none) from depth in metres.
 * NaN, inf, zero, negative and values outside [min_depth, max_depth] become 0. */
cv::Mat
inverseDepth (const cv::Mat& depth, double min_depth, double max_depth);

/** \brief The next coarser level: pixel (i, j) averages, around pixel (2 i, 2 j), those
 * of the 3x3 neighbours that belong to the same surface (inverse depth within the
 * tolerance); where the centre has no measurement the neighbour nearest to the camera
 * stands in. Holes do not grow, surfaces do not mix. All instruction sets give the
 * same bits. */
cv::Mat
halveInverseDepth (const cv::Mat& inverse_depth,
                   double noise,
                   const FrameTuning& tuning,
                   InstructionSet set = chosenInstructionSet());

} // namespace pcl_msf
