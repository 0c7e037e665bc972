// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/point_clouds.h"
#include "core/points/point_solve.h"
#include "core/points/prior_knowledge.h"

#include <memory>

namespace pcl_msf {

/** \brief A target, the source that all targets of a window share, and what is known
 * and found of the motion between them. The solve holds addresses of the rest. */
struct PointFrame {
  PointClouds clouds;
  PriorKnowledge prior;
  std::unique_ptr<PointSolve> solve;
  int before{-1}; ///< place of the frame before it on the way from the source, -1 = it
                  ///< comes next to the source
};

} // namespace pcl_msf
