// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/surface/point_tree.h"

#include <vector>

namespace pcl_msf {

/** \brief Unit normals of points by their neighbours' planes, turned to one side along
 * the surface and outwards where it is closed. */
std::vector<Eigen::Vector3f>
surfaceNormals (const std::vector<Eigen::Vector3f>& points,
                const std::vector<std::vector<FoundPoint>>& neighbors,
                int threads);

/** \brief Share of the scatter of a point's neighbourhood across its plane, [0, 1/3].
 */
float
localRoughness (const std::vector<Eigen::Vector3f>& points,
                int point,
                const std::vector<FoundPoint>& neighbors);

} // namespace pcl_msf
