// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/bodies/hidden_segments.h"
#include "support/covered_wall.h"

namespace {

using namespace pcl_msf;
using test::kBeside;
using test::kCovered;
using test::kFree;
using test::kPlateTile;
using test::kWallTile;

/** \param length of the link's lever; shorter is nearer */
SegmentLink
link (int a, int b, double lever)
{
  return {std::min (a, b), std::max (a, b), Eigen::Vector3d::Zero(), lever};
}

class Hidden : public testing::Test {
protected:
  int
  follow (const std::vector<SegmentLink>& links, MotionState& state)
  {
    DataTerm data = scene_.data();
    data.sweep (state, DataTerm::Pass::Linearize);
    WindowState window (state);
    const int changes = assignHiddenSegments (scene_.terms (data), links, {}, window);
    state = window.ofPair (0);
    return changes;
  }

  /** The covered tile in a body of its own, almost where it is. */
  MotionState
  coveredApart ()
  {
    MotionState state = scene_.solved();
    test::setApart (state, kCovered, test::tilesAway (0.02, 0.01));
    return state;
  }

  test::TiledScene scene_{test::coveredWall()};
};

TEST_F (Hidden, CoveredTileFollowsTheWall)
{
  MotionState state = coveredApart();
  EXPECT_EQ (follow (scene_.links(), state), 1);
  EXPECT_EQ (state.body_of, scene_.solved().body_of);
}

TEST_F (Hidden, FollowsWhomItsPointsObjectToLeast)
{
  // With the plate's motion half of it would be seen, and would look different.
  for (const double plate_lever : {0.1, 0.9}) {
    MotionState state = coveredApart();
    follow ({link (kCovered, kPlateTile, plate_lever), link (kCovered, kFree, 0.5)},
            state);
    EXPECT_EQ (state.body_of[kCovered], 0) << plate_lever;
  }
}

TEST_F (Hidden, FollowsTheNearestWhenItObjectsToNone)
{
  for (const bool below_is_nearer : {true, false}) {
    MotionState state = coveredApart();
    test::setApart (state, kWallTile, RigidPose{}); // as the wall's, by another number
    const int other = state.body_of[kWallTile];
    const double lever = below_is_nearer ? 0.1 : 0.3;
    follow ({link (kCovered, kFree, lever), link (kCovered, kWallTile, 0.2)}, state);
    EXPECT_EQ (state.body_of[kCovered], below_is_nearer ? 0 : other);
  }
}

TEST_F (Hidden, SeenOnesKeepTheirMotions)
{
  MotionState state = scene_.solved();
  test::setApart (state, kWallTile, test::tilesAway (0.1, 0));
  const std::vector<int> before = state.body_of;
  EXPECT_EQ (follow (scene_.links(), state), 0);
  EXPECT_EQ (state.body_of, before);
}

TEST_F (Hidden, HiddenOnesDoNotLead)
{
  // Two of the wall's tiles that leave the image: neither is seen.
  MotionState state = coveredApart();
  test::setApart (state, kBeside, test::tilesAway (20, 0));
  const std::vector<int> before = state.body_of;
  EXPECT_EQ (follow ({link (kCovered, kBeside, 0.1)}, state), 0);
  EXPECT_EQ (state.body_of, before);
  EXPECT_EQ (
      follow ({link (kCovered, kBeside, 0.1), link (kBeside, kWallTile, 0.1)}, state),
      1);
  EXPECT_EQ (state.body_of[kBeside], 0);
  EXPECT_EQ (state.body_of[kCovered], before[kCovered]);
}

TEST_F (Hidden, WithoutLinksNothingHappens)
{
  MotionState state = coveredApart();
  EXPECT_EQ (follow ({}, state), 0);
  EXPECT_EQ (state.body_of[kCovered], 2);
}

} // namespace
