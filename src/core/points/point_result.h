// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/given_segments.h"
#include "core/points/point_frame.h"
#include <pcl_msf/cloud_flow.h>

#include <vector>

namespace pcl_msf {

/** \brief The results of solves, per frame: parts, which are the same in all, joints,
 * and all points of the source moved. */
std::vector<CloudFlow>
makeCloudFlows (const std::vector<PointFrame>& frames,
                const GivenSegments& given,
                const std::vector<Eigen::Vector3f>& source,
                bool merge,
                const PointTuning& tuning,
                int threads);

/** \brief Fills in the report: how it ended, and whether the clouds were found on each
 * other.
 * \param scattered see PointSolve
 * \param tuning how much of the clouds must be found on each other */
void
noteOutcome (const SolveProgress& progress,
             double scattered,
             const PointResultTuning& tuning,
             CloudFlow& flow);

} // namespace pcl_msf
