// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_constraints.h>
#include <pcl_msf/cloud_flow.h>
#include <pcl_msf/export.h>
#include <pcl_msf/multiframe_scene_flow.h>
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

/** \brief A cloud of a window. */
struct CloudFrame {
  std::vector<Eigen::Vector3f> points; ///< not finite = unknown
  std::vector<float> brightness; ///< per point, in any unit, NaN = unknown; empty =
                                 ///< none is known, any other number is refused
  /** Per point, of any length and to either side: which side is out, is found along the
   * surface. Where one is not finite or zero, it is computed; empty = all are. */
  std::vector<Eigen::Vector3f> normals{};
};

/** \brief Registers articulated and deforming bodies given as points without a grid.
 *
 * The source's surface is cut into segments, each moves rigidly, neighbours hold
 * together (Eq. 5 with Eq. 10 and 11); points are matched with their nearest neighbours
 * by place and normal instead of by projection, coarse to fine. Limbs that moved far
 * are found by what bending keeps: the distances along the surface. Segments that move
 * as one are merged to parts.
 *
 * Several clouds, a window, are registered jointly (Eq. 13): each begins where the one
 * before it was found, so that a body that moves on is followed by small steps; then
 * all of them are solved together, with the clouds that follow each other, and the
 * parts are what moves as one in all of them. Time and memory grow with the number of
 * clouds.
 *
 * Nothing depends on the unit of the points. Points that are not finite are unknown in
 * the result. The result does not depend on the number of threads. Objects keep no
 * state: one may be used from several threads.
 */
class PCL_MSF_EXPORT CloudFlowEstimator {
public:
  /** \param solver its max_seconds, threads, merge_bodies and progress; steps,
   * tolerances, levels, linear_solver, flow_proposals, blend_motions and refine_flow
   * are of the camera's way and have no effect
   * \param multiframe of windows its concatenation_weight alone, lambda of Eq. 14
   * between clouds that follow each other; 0 = each cloud is solved for itself, from
   * where the one before it was found, and only the parts are common
   * \throws InvalidInput for bad values */
  explicit CloudFlowEstimator (SolverParameters solver = {},
                               CloudConstraints constraints = {},
                               MultiframeParameters multiframe = {});

  /** \param source, target 20 different finite points or more each
   * \param start where to begin: one rigid motion of all, finite
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

  /** \brief Registers one of several clouds to all others.
   * \param frames two or more, in the order of time; 20 different finite points or more
   * each
   * \param reference index of the frame whose points are followed: the source
   * \param start of all, one rigid motion, finite: into the frame after the reference,
   * or into the one before it when there is none after it
   * \param segments of the reference's points, as in estimate
   * \param brightness_weight [0, 1000], as CloudBrightness's; frames that have none are
   * registered by shape alone
   * \return per frame the reference's points in it, `target_from_source` = frame from
   * reference. Parts, their order and the points' are the same in all; joints and
   * confidence are each frame's own. Frames that were not found say so in their report;
   * counts and times are the whole window's. The reference's own element holds only the
   * report of all: converged when all frames are. Of two frames the result is
   * estimate's, to the bit
   * \throws InvalidInput naming the remedy */
  std::vector<CloudFlow>
  estimateWindow (const std::vector<CloudFrame>& frames,
                  int reference = 0,
                  const RigidPose& start = {},
                  const std::vector<int>& segments = {},
                  double brightness_weight = 1.0) const;

private:
  SolverParameters solver_;
  CloudConstraints constraints_;
  MultiframeParameters multiframe_;
};

} // namespace pcl_msf
