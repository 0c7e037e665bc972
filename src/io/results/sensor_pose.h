// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>

#include <pcl_msf/io/rgbd_images.h>

namespace pcl_msf::io {

template <typename PointT>
void
setViewpoint (const Viewpoint& viewpoint, pcl::PointCloud<PointT>& cloud)
{
  const auto& t = viewpoint.origin;
  const auto& q = viewpoint.orientation;
  cloud.sensor_origin_ = Eigen::Vector4f (t[0], t[1], t[2], 0.0F);
  cloud.sensor_orientation_ = Eigen::Quaternionf (q[0], q[1], q[2], q[3]);
}

} // namespace pcl_msf::io
