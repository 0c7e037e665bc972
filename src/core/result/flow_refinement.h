// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/result/refinement_tile.h"
#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief Where the images may adapt the flow: 255 in CV_8UC1 where points move
 * otherwise than the body that most follow, and do not leave the image. Empty when
 * there are none. */
cv::Mat
pointsToRefine (const SceneFlow& scene, const RefinementTuning& tuning, int threads);

/** \brief What the images say of single points, beside their bodies' motions.
 *
 * Where points move otherwise than most, segments are small, surfaces soft and depth
 * edges off by pixels: no rigid motion fits every pixel. There the flow is adapted to
 * the images, see adaptTile. Segments that this explains no better, beyond the noise,
 * stay as they were. Points keep the depth that their motion gives them and move across
 * the line of sight. Poses stay as they are.
 * \param mask as pointsToRefine () gives it
 * \param result with points, displacement, flow; unknown ones stay unknown */
void
refineFlow (const ComparedImages& images,
            const PinholeCamera& current_camera,
            const cv::Mat& mask,
            const RefinementTuning& tuning,
            int threads,
            SceneFlow& result);

} // namespace pcl_msf
