// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/point_matching.h"

#include <vector>

namespace pcl_msf {

/** \brief Robust standard deviation of what is left of the pulls at moved points, by
 * the median; 0 when nothing pulls. \param least weight of a pull that counts */
double
deviationOf (const MovedPoints& moved,
             const std::vector<PointPull>& pulls,
             double least);

} // namespace pcl_msf
