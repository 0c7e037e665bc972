// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include "core/segments/segment_pixels.h"
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief Fills in what every point does: points, displacement, flow.
 *
 * A point moves with its segment and, where `blend` is on, with the neighbours that the
 * segment is strongly connected to: a mean of their motions, weighted by the connection
 * (w^2) and by the distance from their centres in the image. Inside a rigid body that
 * changes nothing; across a bending surface it takes the steps out.
 * \param points of level 0 \param result with labels, segments and pairs */
void
fillPoints (const SegmentPixels& points,
            const PinholeCamera& target_camera,
            bool blend,
            const BlendTuning& tuning,
            int threads,
            SceneFlow& result);

} // namespace pcl_msf
