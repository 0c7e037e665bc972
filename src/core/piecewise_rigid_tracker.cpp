// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/piecewise_rigid_tracker.h>

namespace pcl_msf {

template class PiecewiseRigidTracker<pcl::PointXYZ>;
template class PiecewiseRigidTracker<pcl::PointXYZI>;
template class PiecewiseRigidTracker<pcl::PointXYZRGB>;
template class PiecewiseRigidTracker<pcl::PointXYZRGBA>;
template class PiecewiseRigidTracker<pcl::PointXYZRGBNormal>;

} // namespace pcl_msf
