// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/tuning/result_tuning.h"

namespace pcl_msf {

/** \brief What a flow is adapted to: intensities that compare, CV_32FC1 of full size.
 */
struct ComparedImages {
  cv::Mat reference, current;
  double noise; ///< of their difference, standard deviation
  cv::Mat flow; ///< optical flow, CV_32FC2, pixels; may be empty
};

/** \brief A part of the images with its adapted flow. */
struct RefinementTile {
  cv::Rect part;        ///< of the images: the tile and what is around it
  cv::Mat flow;         ///< CV_32FC2, pixels
  cv::Mat own_residual; ///< CV_32FC1, by the flow that it began with, at most
                        ///< RefinementTuning's; 0 where that leaves the image
  cv::Mat residual;     ///< by the adapted flow
};

/** \brief Adapts a tile's flow: takes the optical flow where it explains the images
 * clearly better, then refines all (cv::VariationalRefinement, after Brox et al. 2004).
 *
 * Runs in the calling thread and depends on the tile alone.
 * \param flow of the images, NaN = unknown \param mask CV_8UC1, 0 = need not be right
 */
RefinementTile
adaptTile (const ComparedImages& images,
           const cv::Mat& flow,
           const cv::Mat& mask,
           const cv::Rect& tile,
           const RefinementTuning& tuning);

} // namespace pcl_msf
