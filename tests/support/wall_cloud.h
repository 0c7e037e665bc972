// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <pcl_msf/pinhole_camera.h>

#include <limits>

namespace pcl_msf::testing {

inline const PinholeCamera kCamera{50.0, 48.0, 19.0, 14.5};

/** A flat wall at 2 m as the camera sees it, one point missing. */
template <typename PointT>
pcl::PointCloud<PointT>
wall ()
{
  pcl::PointCloud<PointT> cloud (40, 30);
  for (int row = 0; row < 30; ++row)
    for (int col = 0; col < 40; ++col) {
      const Eigen::Vector3f p = kCamera.backProject (col, row, 2.0).cast<float>();
      cloud (col, row).getVector3fMap() = p;
    }
  cloud (3, 4).getVector3fMap().setConstant (std::numeric_limits<float>::quiet_NaN());
  cloud.is_dense = false;
  return cloud;
}

} // namespace pcl_msf::testing
