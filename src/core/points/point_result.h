// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/point_solve.h"
#include <pcl_msf/cloud_flow.h>

#include <vector>

namespace pcl_msf {

/** \brief The result of a solve: parts, joints, and all points of the source moved. */
CloudFlow
makeCloudFlow (const PointClouds& clouds,
               const PriorKnowledge& prior,
               const GivenSegments& given,
               PointSolve& solve,
               const std::vector<Eigen::Vector3f>& source,
               bool merge,
               const PointTuning& tuning,
               int threads);

/** \brief Fills in the report: how it ended, and whether the clouds were found on each
 * other.
 * \param tuning how much of the clouds must be found on each other */
void
noteOutcome (const SolveProgress& progress,
             const PointResultTuning& tuning,
             CloudFlow& flow);

} // namespace pcl_msf
