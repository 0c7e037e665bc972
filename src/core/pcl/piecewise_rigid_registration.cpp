// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/piecewise_rigid_registration.h>

static_assert (PCL_MSF_SAME_LAYOUT,
               "the flags are others than those that config.h was made for: give them "
               "in CMAKE_CXX_FLAGS and configure again");

namespace pcl_msf {

template class PiecewiseRigidRegistration<pcl::PointXYZ>;
template class PiecewiseRigidRegistration<pcl::PointXYZI>;
template class PiecewiseRigidRegistration<pcl::PointXYZRGB>;
template class PiecewiseRigidRegistration<pcl::PointXYZRGBA>;
template class PiecewiseRigidRegistration<pcl::PointNormal>;
template class PiecewiseRigidRegistration<pcl::PointXYZINormal>;
template class PiecewiseRigidRegistration<pcl::PointXYZRGBNormal>;

} // namespace pcl_msf
