// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/piecewise_rigid_registration.h>

bool
isStill (pcl_msf::PiecewiseRigidRegistration<pcl::PointXYZRGB>& registration)
{
  return registration.getFinalTransformation().isIdentity();
}
