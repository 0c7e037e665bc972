// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/synthetic/body_clouds.h>

#include <vector>

namespace pcl_msf::synthetic {

/** \brief A box, along the axes when the body is at rest, and the joint that it hangs
 * on. */
struct BodyLink {
  int parent{-1}; ///< -1 = the root
  Eigen::Vector3d center;
  Eigen::Vector3d half; ///< sizes
  Eigen::Vector3d joint{Eigen::Vector3d::Zero()};
  Eigen::Vector3d axis{Eigen::Vector3d::UnitZ()}; ///< unit
};

/** \brief The links of a body at rest, parents first. */
std::vector<BodyLink>
bodyLinks (BodyKind body);

} // namespace pcl_msf::synthetic
