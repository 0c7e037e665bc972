// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/parameters.h>

#include <string>

namespace pcl_msf {

/** \brief Is there a depth within the limits?
 * \param depth CV_32FC1; NaN, inf, zero and negative = no measurement
 * \param[out] why when not null and the answer is no: what was found, and the remedy */
bool
hasDepth (const cv::Mat& depth,
          const FrameParameters& parameters,
          std::string* why = nullptr);

/** \brief What the limits drop, where that is probably not meant: depth beyond a limit
 * that no camera reaches, or nearly all of it. \return empty otherwise */
std::string
droppedDepth (const cv::Mat& depth, const FrameParameters& parameters);

} // namespace pcl_msf
