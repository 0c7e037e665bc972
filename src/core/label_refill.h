// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/oversegmentation.h>

#include <vector>

namespace pcl_msf {

/** \brief Share of the points with depth that bear a label. */
double
labelledShare (const cv::Mat& labels, const cv::Mat& inverse_depth);

/** \brief Labels in place, and what they leave open: a fresh segment where most of one
 * is open, else the label that most of it bears. \param first_fresh number of fresh
 * segment 0 in the result */
cv::Mat
fillWithFresh (const cv::Mat& labels, const Oversegmentation& fresh, int first_fresh);

/** \brief The labels that Oversegmentation::fromLabels numbers, in its order. */
std::vector<int>
labelsInOrder (const cv::Mat& labels, const cv::Mat& inverse_depth);

} // namespace pcl_msf
