// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/rigid_pose.h>
#include <pcl_msf/scene_flow.h>

#include <string>
#include <vector>

namespace pcl_msf {

/** \brief Weights and rules of the multiframe energy (Eq. 13) beside those of Eq. 5. */
struct PCL_MSF_EXPORT MultiframeParameters {
  double concatenation_weight{0.1}; ///< lambda, [0, 1e9]; divided by the number of
                                    ///< segments, per pair (Eq. 14)
  int max_span{0}; ///< pairs without the reference are left out when their frames are
                   ///< farther apart; 0 = all pairs are used, >= 0
  bool static_background{false}; ///< prior: the largest body is a rigid background that
                                 ///< segments belong to unless their points object. The
                                 ///< background's motion gains where it has no texture;
                                 ///< slow objects without texture are taken for it

  bool
  isValid (std::string* why = nullptr) const;
};

/** \brief Poses of all segments for one pair of frames: T_k^{l,m}. */
struct PairMotion {
  int from{0};                     ///< l, index in the window
  int to{0};                       ///< m
  std::vector<RigidPose> segments; ///< per segment, `to_from_from`
};

/** \brief The result for a window of frames. Frames are in the order of time. */
struct PCL_MSF_EXPORT MultiframeSceneFlow {
  int reference{0};

  /** \brief Per frame of the window: where the reference's points are in it. Labels,
   * pairs (the shared weights) and motion groups are the same in all. The reference's
   * own element holds no images, no segments, and the report of the whole window. */
  std::vector<SceneFlow> frames;

  /** \brief Poses of every pair of frames that was used; a pair leads away from the
   * reference, see poseBetween. */
  std::vector<PairMotion> motions;

  /** \brief The whole window's report: times, iterations, energy of Eq. 13. Without
   * frames an empty one, which has StopReason::NotRun. */
  const Report&
  report () const;

  /** \brief T_k^{from,to} for any two frames: the pair's own pose, its inverse, or,
   * where no such pair was used, by way of the reference. Identity for from = to.
   * \throws InvalidInput for frames or segments that there are none of */
  RigidPose
  poseBetween (int from, int to, int segment) const;
};

} // namespace pcl_msf
