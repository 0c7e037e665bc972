// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/synthetic/synthetic_sequence.h>
#include <synthetic/frame_view.h>

#include <vector>

namespace pcl_msf::synthetic {

/** \brief Depth at pixel centres, CV_32FC1, NaN where nothing is hit. */
cv::Mat
depthOf (const cv::Size& size, const std::vector<ViewHit>& hits);

/** \brief Body of each pixel, CV_32SC1, -1 where nothing is hit. */
cv::Mat
labelsOf (const SceneModel& scene,
          const FrameView& view,
          const std::vector<ViewHit>& hits);

/** \brief Where the points of one view are in another.
 * \param hits of all pixel centres of `from` */
GroundTruth
truthBetween (const FrameView& from,
              const std::vector<ViewHit>& hits,
              const FrameView& to,
              int threads);

/** \brief Average length of the flow from one view to another, pixels: over all points
 * or over those of moving bodies, whichever is more. A point counts with at most the
 * image's width. */
double
meanMotion (const SceneModel& scene,
            const FrameView& from,
            const std::vector<ViewHit>& hits,
            const FrameView& to);

} // namespace pcl_msf::synthetic
