// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_constraints.h>
#include <pcl_msf/cloud_flow.h>
#include <pcl_msf/export.h>
#include <pcl_msf/parameters.h>

#include <vector>

namespace pcl_msf {

/** \brief Registers articulated and deforming bodies given as points without a grid.
 *
 * The source's surface is cut into segments, each moves rigidly, neighbours hold
 * together (Eq. 5 with Eq. 10 and 11); points are matched with their nearest neighbours
 * by place and normal instead of by projection, coarse to fine. Limbs that moved far
 * are found by what bending keeps: the distances along the surface. Segments that move
 * as one are merged to parts.
 *
 * Nothing depends on the unit of the points. Points that are not finite are unknown in
 * the result. The result does not depend on the number of threads. Objects keep no
 * state: one may be used from several threads.
 */
class PCL_MSF_EXPORT CloudFlowEstimator {
public:
  /** \throws InvalidInput for bad values */
  explicit CloudFlowEstimator (SolverParameters solver = {},
                               CloudConstraints constraints = {});

  /** \param source, target 20 different finite points or more each
   * \param start where to begin: one rigid motion of all
   * \param segments a label per source point, negative = takes no part and is unknown
   * in the result; empty = the surface is cut into segments. Given ones are used as
   * they are: each is rigid up to its border and in one part (`merge_bodies` tells
   * whether several may share one); those hold together that touch, or all but touch
   * \throws InvalidInput naming the remedy */
  CloudFlow
  estimate (const std::vector<Eigen::Vector3f>& source,
            const std::vector<Eigen::Vector3f>& target,
            const RigidPose& start = {},
            const std::vector<int>& segments = {}) const;

private:
  SolverParameters solver_;
  CloudConstraints constraints_;
};

} // namespace pcl_msf
