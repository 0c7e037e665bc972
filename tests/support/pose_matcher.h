// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <pcl_msf/rigid_pose.h>

#include <string>

namespace pcl_msf::test {

/** \brief A pose within an angle and a distance of another one: EXPECT_THAT (found,
 * isNear (truth, 0.001, 0.002)). Tells both when it is not.
 * \param radians between the rotations \param metres between the translations */
MATCHER_P3 (isNear,
            expected,
            radians,
            metres,
            "is within " + ::testing::PrintToString (radians) + " radians and " +
                ::testing::PrintToString (metres) + " metres of " +
                ::testing::PrintToString (expected.parameters))
{
  const RigidPose& found = arg;
  const double angle = (found * expected.inverse()).angle();
  const double distance = (found.translation() - expected.translation()).norm();
  *result_listener << ::testing::PrintToString (found.parameters) << ", turned by "
                   << angle << " radians and shifted by " << distance << " metres";
  return angle <= radians && distance <= metres;
}

} // namespace pcl_msf::test
