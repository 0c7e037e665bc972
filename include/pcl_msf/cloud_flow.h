// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/build_compatibility.h>
#include <pcl_msf/rigid_pose.h>
#include <pcl_msf/scene_flow.h>

#include <array>
#include <vector>

namespace pcl_msf {

/** \brief A rigid part of a body: points that move as one. */
struct CloudPart {
  RigidPose target_from_source;         ///< its motion, in the unit of the points
  Matrix6 information{Matrix6::Zero()}; ///< of the six pose parameters, data terms only
  int points{0};                        ///< of the source
  Eigen::Vector3d centroid{Eigen::Vector3d::Zero()}; ///< source frame
};

/** \brief How one part turns against another that it touches. Deviations are one
 * sigma. */
struct CloudJoint {
  int parent{0};                                  ///< the larger part
  int child{0};                                   ///< the smaller one
  Eigen::Vector3d axis{Eigen::Vector3d::UnitZ()}; ///< unit, source frame
  double angle{0.0};                              ///< radians, [0, pi]
  Eigen::Vector3d point{Eigen::Vector3d::Zero()}; ///< on the axis, source frame
  double shift{0.0};                              ///< along the axis; 0 for a hinge
  double angle_deviation{0.0};                    ///< radians
  double axis_deviation{0.0};  ///< radians; pi / 2 = the angle is too small to tell
  double point_deviation{0.0}; ///< across the axis, unit of the points
};

/** \brief Where every point of a cloud without a grid has gone. */
struct CloudFlow {
  std::vector<Eigen::Vector3f> warped; ///< per source point; NaN = unknown
  std::vector<int> part;               ///< per source point; -1 = none
  std::vector<int> target;       ///< per source point: nearest target point, or -1
  std::vector<float> confidence; ///< per source point, [0, 1]: how well the target
                                 ///< shows a surface where it is moved to, less
                                 ///< where the source was stretched to get there
  std::vector<int> segment;      ///< per source point, of given segments: its place in
                                 ///< ascending order of labels, -1 = none; else empty
  std::vector<int> segment_part; ///< per given segment, its part
  std::vector<std::array<int, 2>> touching; ///< given segments, the first one less
  std::vector<CloudPart> parts;             ///< largest first
  std::vector<CloudJoint> joints;           ///< of parts that touch
  double explained_source{0.0}; ///< share of the source's surface seen there
  double explained_target{0.0}; ///< share of the target's that the source covers
  double unexplained{0.0};      ///< share of either cloud, the less one, that is bare
                                ///< though the other one is not cut off there
  double loose_target{0.0};     ///< share of the target in the largest piece that the
                                ///< source leaves bare though it is not cut off
                                ///< there: a limb lies elsewhere
  double self_overlap{0.0};     ///< share of the source that has come to lie on another
                                ///< part of it that faces the same way, which surfaces
                                ///< cannot: a limb ended on another, or is crushed
  double gap{0.0};              ///< between neighbouring segments, mean, in radii of a
                                ///< segment: much = torn or twisted
  Report report;
};

} // namespace pcl_msf
