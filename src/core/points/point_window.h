// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/concatenation_cost.h"
#include "core/points/point_frame.h"

#include <vector>

namespace pcl_msf {

/** \brief Centre and spread of the points of every segment, of its centroid alone when
 * it has none. */
std::vector<BodyShape>
segmentShapes (const PointSamples& samples,
               const std::vector<int>& label,
               const SurfaceSegments& segments);

/** \brief Solves all targets of a window jointly (Eq. 13), from where each one's own
 * solve has ended: their data terms, those between targets that follow each other, and
 * the concatenation of their motions (Eq. 14), which holds what one pair leaves open.
 * \param weight lambda; 0 = the targets stay as they are */
void
solveJointly (std::vector<PointFrame>& frames,
              double weight,
              const PointTuning& tuning,
              int threads,
              SolveProgress& progress);

} // namespace pcl_msf
