// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/surface_tuning.h"
#include "core/surface/point_tree.h"

#include <vector>

namespace pcl_msf {

/** \brief Unit normals of points by their neighbours' planes, turned to one side along
 * the surface and outwards where it is closed.
 * \param given per point, taken as they are but for length and side; where one is not
 * finite or zero, and of all points when it is empty, neighbours tell */
std::vector<Eigen::Vector3f>
surfaceNormals (const std::vector<Eigen::Vector3f>& points,
                const std::vector<std::vector<FoundPoint>>& neighbors,
                const SurfaceTuning& tuning,
                int threads,
                const std::vector<Eigen::Vector3f>& given = {});

/** \brief How far a point is from the plane of its neighbours, and how far these are
 * from it themselves (one deviation). */
struct PlaneFit {
  float offset{0.0f};
  float roughness{0.0f};
};

PlaneFit
fitNeighbors (const std::vector<Eigen::Vector3f>& points,
              int point,
              const std::vector<FoundPoint>& neighbors);

} // namespace pcl_msf
