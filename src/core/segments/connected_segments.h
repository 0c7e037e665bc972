// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/tuning/segment_tuning.h"
#include <pcl_msf/rgbd_frame.h>

namespace pcl_msf {

/** \brief Splits labels into parts connected on one surface and gives small parts to
 * the neighbour whose surface continues into them best.
 *
 * Two neighbouring pixels are connected when they bear the same label and each lies on
 * the other's tangent plane within the noise. Parts below min_points go to the
 * neighbouring part with the best such edge; isolated ones stay with their label.
 * \param labels CV_32SC1, -1 = none; \return the same, not necessarily dense */
cv::Mat
connectSegments (const cv::Mat& labels,
                 const FrameLevel& level,
                 double inverse_depth_noise,
                 int min_points,
                 const SegmentTuning& tuning,
                 int threads);

} // namespace pcl_msf
