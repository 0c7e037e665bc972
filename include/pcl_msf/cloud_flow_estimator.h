// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_constraints.h>
#include <pcl_msf/cloud_flow.h>
#include <pcl_msf/export.h>
#include <pcl_msf/parameters.h>

#include <vector>

namespace pcl_msf {

/** \brief How bright the points of two clouds are, in any unit; NaN = unknown. */
struct CloudBrightness {
  std::vector<float> source; ///< per point
  std::vector<float> target; ///< per point
  double weight{1.0}; ///< [0, 1000] of what it tells beside the shape; 0 = not used

  /** \brief Does it tell nothing? */
  bool
  empty () const
  {
    return (source.empty() && target.empty()) || weight == 0.0;
  }
};

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
   * \param brightness where it varies over both surfaces by more than noise, points go
   * to where the target is as bright, too: what slides within its own surface is found
   * by nothing else. Exposure (gain and offset) may differ. Empty = none
   * \throws InvalidInput naming the remedy */
  CloudFlow
  estimate (const std::vector<Eigen::Vector3f>& source,
            const std::vector<Eigen::Vector3f>& target,
            const RigidPose& start = {},
            const std::vector<int>& segments = {},
            const CloudBrightness& brightness = {}) const;

private:
  SolverParameters solver_;
  CloudConstraints constraints_;
};

} // namespace pcl_msf
