// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/motion/motion_state.h"

#include <vector>

namespace {

using namespace pcl_msf;

RigidPose
at (double x)
{
  RigidPose pose;
  pose.parameters = {0.0, 0.0, 0.0, x, 0.0, 0.0};
  return pose;
}

/** A row of six segments of their own, each linked to the next. */
class Row : public testing::Test {
protected:
  Row()
  {
    for (int k = 0; k + 1 < 6; ++k)
      links_.push_back ({k, k + 1, Eigen::Vector3d::Zero(), 0.1, 1.0});
    state_ = WindowState (MotionState::fromSegments (
        {at (1), at (1), at (2), at (1), at (1), at (1)}, links_.size()));
  }

  std::vector<SegmentLink> links_;
  WindowState state_;
};

TEST_F (Row, LinkedSegmentsOfOnePoseAreOneBody)
{
  state_.joinEqualPoses (links_);
  EXPECT_EQ (state_.body_of, (std::vector<int>{0, 0, 1, 2, 2, 2}))
      << "what lies apart stays apart";
  ASSERT_EQ (state_.bodies(), 3);
  EXPECT_EQ (state_.poses[0][1].parameters, at (2).parameters);
  EXPECT_EQ (state_.weights.size(), links_.size());
}

TEST_F (Row, SomeStayByThemselves)
{
  state_.joinEqualPoses (links_, {0, 0, 0, 0, 1, 0});
  EXPECT_EQ (state_.body_of, (std::vector<int>{0, 0, 1, 2, 3, 4}));
}

TEST_F (Row, PosesAreEqualInAllPairs)
{
  state_.poses.push_back (state_.poses[0]);
  state_.poses[1][5] = at (7);
  state_.joinEqualPoses (links_);
  EXPECT_EQ (state_.body_of, (std::vector<int>{0, 0, 1, 2, 2, 3}));
  EXPECT_EQ (state_.poses[1][3].parameters, at (7).parameters);
}

TEST_F (Row, SeparatedSegmentsKeepTheirBodiesPoses)
{
  state_.joinEqualPoses (links_);
  state_.poses[0][2] = at (9);
  state_.separate();
  EXPECT_EQ (state_.body_of, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  ASSERT_EQ (state_.bodies(), 6);
  EXPECT_EQ (state_.poses[0][1].parameters, at (1).parameters);
  EXPECT_EQ (state_.poses[0][5].parameters, at (9).parameters);
}

} // namespace
