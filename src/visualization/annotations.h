// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/visualization/scene.h>
#include <pcl_msf/visualization/view.h>

namespace pcl_msf::visualization {

/** \brief Draws what the style asks for over a rendered scene: title (upper left),
 * legend below it, colour scale (lower right), axes and, for parallel views, a length
 * in metres (lower left). Sizes follow the picture's. \param picture CV_8UC3 */
void
annotate (cv::Mat& picture,
          const Scene& scene,
          const View& view,
          const PictureStyle& style);

/** \brief 1, 2 or 5 times a power of ten, the largest that is not above `limit`. */
double
roundLength (double limit);

} // namespace pcl_msf::visualization
