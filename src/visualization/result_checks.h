// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/visualization/result_scenes.h>

namespace pcl_msf::visualization {

/** \brief \throws InvalidInput unless points, displacement, labels and visibility are
 * there and all images of one size */
void
requireResult (const ResultClouds& result);

/** \brief \throws InvalidInput without displacements or when one does not fit */
void
requireDisplacements (const ResultClouds& result,
                      const std::vector<cv::Mat>& displacements);

/** \brief \throws InvalidInput without a current cloud */
void
requireCurrent (const ResultClouds& result);

} // namespace pcl_msf::visualization
