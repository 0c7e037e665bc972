// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include "core/motion/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief The sparse adjacency Psi: each segment with its n_psi nearest centroids, each
 * pair once, sorted. \param centroids metres */
std::vector<SegmentLink>
linkNearestCentroids (const std::vector<Eigen::Vector3d>& centroids, int neighbors);

/** \brief Per segment, its neighbours in the links. */
std::vector<std::vector<int>>
neighborLists (const std::vector<SegmentLink>& links, int segments);

} // namespace pcl_msf
