// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_msf {

/** \brief About `count` of the points, evenly over the surface: one in a cube, both
 * sides of a thin part kept. All of them when there are not more.
 * \param normals may be empty \return indices, ascending */
std::vector<int>
thinPoints (const std::vector<Eigen::Vector3f>& points,
            const std::vector<Eigen::Vector3f>& normals,
            int count);

/** \brief `count` of some points, each as far as can be from those before it.
 * \return places in `chosen` */
std::vector<int>
spreadPoints (const std::vector<Eigen::Vector3f>& points,
              const std::vector<int>& chosen,
              int count);

} // namespace pcl_msf
