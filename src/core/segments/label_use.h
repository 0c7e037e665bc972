// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <vector>

namespace pcl_msf {

/** \brief Share of the points with depth that bear a label. */
double
labelledShare (const cv::Mat& labels, const cv::Mat& inverse_depth);

/** \brief The labels that Oversegmentation::fromLabels numbers, in its order. */
std::vector<int>
labelsInOrder (const cv::Mat& labels, const cv::Mat& inverse_depth);

} // namespace pcl_msf
