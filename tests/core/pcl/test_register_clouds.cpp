// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <gmock/gmock.h>
#include <pcl_msf/register_clouds.h>
#include <pcl_msf/version.h>

#include <string>

namespace {

using namespace pcl_msf;

using Cloud = RigidPair::Cloud;

TEST (RegisterClouds, IsTheRegistrationWithItsDefaults)
{
  const Cloud::Ptr reference = RigidPair::reference();
  const Cloud::ConstPtr current = RigidPair::current();
  PiecewiseRigidRegistration<pcl::PointXYZRGB> registration;
  registration.setInputSource (reference);
  registration.setInputTarget (current);
  Cloud warped;
  registration.align (warped);
  const auto result = registerClouds (Cloud::ConstPtr (reference), current);
  EXPECT_TRUE (result.converged);
  ASSERT_EQ (result.warped.size(), warped.size());
  ASSERT_TRUE (result.warped.isOrganized());
  for (std::size_t i = 0; i < warped.size(); ++i)
    if (!std::isnan (warped[i].x)) {
      ASSERT_EQ (result.warped[i].z, warped[i].z) << i;
    }
  EXPECT_EQ (result.scene_flow.dominant_motion.parameters,
             registration.getSceneFlow().dominant_motion.parameters);
  for (const auto& same : {registerClouds (reference, current),
                           registerClouds (reference, RigidPair::current())})
    EXPECT_EQ (same.scene_flow.dominant_motion.parameters,
               result.scene_flow.dominant_motion.parameters);
  const auto copied = registerClouds (*reference, *current);
  EXPECT_EQ (copied.scene_flow.dominant_motion.parameters,
             result.scene_flow.dominant_motion.parameters);
}

TEST (RegisterClouds, SaysWhyItHasFailed)
{
  ::testing::internal::CaptureStderr();
  const auto result = registerClouds (RigidPair::reference(), Cloud::Ptr());
  const std::string printed = ::testing::internal::GetCapturedStderr();
  EXPECT_FALSE (result.converged);
  EXPECT_THAT (result.scene_flow.report.message, ::testing::Not (::testing::IsEmpty()));
  EXPECT_THAT (printed, ::testing::HasSubstr ("target"));
}

TEST (Version, IsOneInAllItsForms)
{
  EXPECT_EQ (std::string (PCL_MSF_VERSION_PRETTY),
             std::to_string (PCL_MSF_VERSION_MAJOR) + "." +
                 std::to_string (PCL_MSF_VERSION_MINOR) + "." +
                 std::to_string (PCL_MSF_VERSION_PATCH));
  static_assert (PCL_MSF_VERSION_COMPARE (>=, 0, 1, 0));
  static_assert (PCL_MSF_VERSION_COMPARE (<, 100, 0, 0));
}

} // namespace
