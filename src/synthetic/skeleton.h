// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <synthetic/scene_model.h>

#include <memory>
#include <vector>

namespace pcl_msf::synthetic {

/** \brief A joint and the link behind it. The link's frame is the joint's, turned. */
struct Joint {
  int parent{-1}; ///< index of the link before, -1 = the world
  Isometry parent_from_joint{Isometry::Identity()}; ///< at rest
  Eigen::Vector3d turn{Eigen::Vector3d::Zero()};    ///< radians per phase, joint's axes
  double start{0.0}; ///< place in the swing at phase 0, radians
};

/** \brief A tree of links, parents first. */
class Skeleton {
public:
  /** \return the link's index */
  int
  add (const Joint& joint);

  Isometry
  worldFromLink (int link, double phase) const;

private:
  std::vector<Joint> joints_;
};

/** \brief A link's motion; keeps the skeleton alive. */
Motion
linkMotion (const std::shared_ptr<const Skeleton>& skeleton, int link);

} // namespace pcl_msf::synthetic
