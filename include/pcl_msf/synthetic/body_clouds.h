// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/export.h>
#include <pcl_msf/rigid_pose.h>

#include <string>
#include <vector>

namespace pcl_msf::synthetic {

/** \brief Articulated bodies, made of boxes. About a metre large. */
enum class BodyKind {
  Chain, ///< four links in a row
  Hand,  ///< a palm and five fingers of two links
  Animal ///< a trunk, four legs of two links, neck and head, a tail
};

/** \brief "chain", "hand", "animal" */
PCL_MSF_EXPORT const char*
toString (BodyKind body);

/** \brief All bodies, in the order of the enumeration. */
PCL_MSF_EXPORT const std::vector<BodyKind>&
allBodies ();

/** \brief What to draw. The same options give the same clouds. */
struct PCL_MSF_EXPORT BodyOptions {
  BodyKind body{BodyKind::Chain};
  int points{6000};   ///< of each cloud before anything is cut, [100, 10 000 000]
  double angle{10.0}; ///< degrees, that a joint turns by at the most, [0, 170]
  double noise{0.0};  ///< metres a coordinate, on both clouds, [0, 1]
  double outliers{
      0.0};         ///< further target points anywhere, shares of the points, [0, 1]
  double cut{0.0};  ///< share of the target's points cut off by a plane, [0, 0.9]
  unsigned seed{1}; ///< places of points, angles, motion of the whole

  /** \param[out] why when not null and the answer is no: which value and its range */
  bool
  isValid (std::string* why = nullptr) const;
};

/** \brief How a link turns against the one that it hangs on; in the source's pose. */
struct BodyJoint {
  int child{0};
  int parent{0};
  Eigen::Vector3d axis{Eigen::Vector3d::UnitZ()}; ///< unit
  double angle{0.0};                              ///< radians, may be negative
  Eigen::Vector3d point{Eigen::Vector3d::Zero()}; ///< on the axis
};

/** \brief A body seen twice, each time by other points of its outside: what lies inside
 * another link is not there. Metres. */
struct BodyClouds {
  std::vector<Eigen::Vector3f> source;
  std::vector<Eigen::Vector3f> target; ///< in no order
  std::vector<Eigen::Vector3f> truth;  ///< per source point, where it lies in the
                                       ///< target's frame; NaN where that is cut off
  std::vector<int> link;               ///< per source point
  std::vector<RigidPose> poses;        ///< per link, target from source
  std::vector<BodyJoint> joints;
};

/** \throws InvalidInput when the options are not valid */
PCL_MSF_EXPORT BodyClouds
synthesizeBody (const BodyOptions& options);

/** \brief The body seen again and again as it goes on moving: the target of the k-th,
 * from 1, has joints turned k times as far as the first one's, and the whole moved k
 * times as far. The source is the same in all, the first is synthesizeBody's.
 * \param targets 1 or more \throws InvalidInput when it is not, nor the options valid
 */
PCL_MSF_EXPORT std::vector<BodyClouds>
synthesizeBodySequence (const BodyOptions& options, int targets);

/** \brief Writes source.ply, target.ply, truth.ply, labels.txt (a link a line),
 * poses.txt (a row-major 4x4 `target_from_source` a link), joints.txt (`child parent
 * axis(xyz) angle_deg point(xyz)` a joint, source pose). \throws IoError */
PCL_MSF_EXPORT void
writeBody (const BodyClouds& clouds, const std::string& folder);

} // namespace pcl_msf::synthetic
