// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <pcl_msf/piecewise_rigid_registration.h>

namespace {

using namespace pcl_msf;

TEST (RegistrationFinestLevel, EveryPointOfTheSourceIsCarried)
{
  const RigidPair::Cloud::Ptr reference = RigidPair::reference();
  PiecewiseRigidRegistration<pcl::PointXYZRGB> registration;
  registration.setInputSource (reference);
  registration.setInputTarget (RigidPair::current());
  FrameParameters half;
  half.finest_level = 1;
  registration.setFrameParameters (half);
  RigidPair::Cloud warped;
  registration.align (warped);
  EXPECT_TRUE (registration.hasConverged());
  ASSERT_EQ (warped.width, reference->width);
  ASSERT_EQ (warped.height, reference->height);
  double sum = 0.0;
  int known = 0;
  for (std::size_t i = 0; i < warped.size(); ++i) {
    const Eigen::Vector3d p = reference->points[i].getVector3fMap().cast<double>();
    const Eigen::Vector3d q = warped[i].getVector3fMap().cast<double>();
    if (!q.allFinite())
      continue;
    sum += (RigidPair::motion() * p - q).norm();
    ++known;
  }
  EXPECT_GT (known, 0.95 * RigidPair::kWidth * RigidPair::kHeight);
  EXPECT_LT (sum / known, 0.003);
  const RigidPose found = RigidPose::fromMatrix (registration.getFinalTransformation());
  const Eigen::Vector3d ahead (0.0, 0.0, 2.0);
  EXPECT_LT ((found * ahead - RigidPair::motion() * ahead).norm(), 0.01);
}

} // namespace
