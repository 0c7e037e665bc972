// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

namespace pcl_msf::evaluation {

/** \brief \throws InvalidInput, naming the image, unless it has this type and size */
void
requireImage (const char* name, const cv::Mat& image, int type, const cv::Size& size);

} // namespace pcl_msf::evaluation
