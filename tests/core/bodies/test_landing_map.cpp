// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/bodies/landing_map.h"
#include "support/covered_wall.h"

#include <vector>

namespace {

using namespace pcl_msf;

// Places are told apart to three pixels: tiles beside reach over the border.
constexpr double kSeam = 0.25;
constexpr double kCost = 0.5; // of the segment that is asked for

class LandingMapTest : public testing::Test {
protected:
  double
  occupied (const MotionState& state,
            int segment,
            int body,
            double cost_of_others = 0.0)
  {
    const DataTerm data = scene_.data();
    LandingMap map (data, {});
    const int segments = data.pixels().segments();
    map.enter (state, std::vector<double> (segments, cost_of_others), 1);
    return map.occupiedShare (data, segment, body, kCost);
  }

  /** The covered tile in a body of its own, which lands on a tile of the wall. */
  MotionState
  onTheFreeTile ()
  {
    MotionState state = scene_.solved();
    test::setApart (state, test::kCovered, test::tilesAway (0, 1));
    return state;
  }

  test::TiledScene scene_{test::coveredWall()};
};

TEST_F (LandingMapTest, PlaceOfALargerBodyIsOccupied)
{
  EXPECT_GT (occupied (onTheFreeTile(), test::kCovered, 2), 0.9);
}

TEST_F (LandingMapTest, LargerBodyIsKeptAmongMany)
{
  // Three small bodies land there before the wall does.
  test::wipeTexture (scene_.pixels(), 0, 47);
  MotionState state = onTheFreeTile();
  for (const int row : {0, 1})
    test::setApart (state, test::kFree - 8 * (3 - row), test::tilesAway (0, 3 - row));
  EXPECT_GT (occupied (state, test::kCovered, 2), 0.9);
}

TEST_F (LandingMapTest, OnlyThePointsOnThatPlaceCount)
{
  // Half of the tile stays on its own place, half lands on the tile below.
  MotionState state = scene_.solved();
  test::setApart (state, test::kFree, test::tilesAway (0, 0.5));
  const double share = occupied (state, test::kFree, 2);
  EXPECT_GE (share, 0.5);
  EXPECT_LE (share, 0.5 + kSeam);
}

TEST_F (LandingMapTest, OwnBodyLeavesRoom)
{
  const MotionState state = onTheFreeTile();
  EXPECT_EQ (occupied (scene_.solved(), test::kFree, 0), 0.0);
  EXPECT_EQ (occupied (state, test::kWallTile, 0), 0.0);
  EXPECT_LT (occupied (scene_.solved(), test::kPlateTile, 1), kSeam);
}

TEST_F (LandingMapTest, SmallerBodyDoesNotOccupy)
{
  test::wipeTexture (scene_.pixels(), test::kCovered, test::kCovered);
  EXPECT_EQ (occupied (onTheFreeTile(), test::kFree, 0), 0.0);
}

TEST_F (LandingMapTest, NeitherOfTwoEqualBodiesOccupies)
{
  MotionState state = onTheFreeTile();
  test::setApart (state, test::kFree, RigidPose{});
  EXPECT_LT (occupied (state, test::kCovered, 2), kSeam);
  EXPECT_LT (occupied (state, test::kFree, 3), kSeam);
}

TEST_F (LandingMapTest, WhatFitsClearlyWorseOccupiesNothing)
{
  const double worse = LandingTuning{}.worse;
  EXPECT_GT (occupied (onTheFreeTile(), test::kCovered, 2, kCost + 0.9 * worse), 0.9);
  EXPECT_EQ (occupied (onTheFreeTile(), test::kCovered, 2, kCost + 1.1 * worse), 0.0);
}

TEST_F (LandingMapTest, WhatLooksDifferentOccupiesNothing)
{
  SegmentPixels& pixels = scene_.pixels();
  for (int i = pixels.begin[test::kFree]; i < pixels.begin[test::kFree + 1]; ++i)
    pixels.intensity[i] += 0.9f;
  EXPECT_LT (occupied (onTheFreeTile(), test::kCovered, 2), kSeam);
}

TEST_F (LandingMapTest, WhatFloatsBeforeOrBehindTheSurfaceOccupiesNothing)
{
  test::wipeTexture (scene_.pixels(), 0, 47);
  for (const double off : {-0.3, 0.3}) {
    MotionState state = onTheFreeTile();
    state.poses[0] = test::turnAbout ({0, 0, 0}, {0, 0, 0}, {0, 0, off});
    EXPECT_EQ (occupied (state, test::kCovered, 2), 0.0) << off;
    EXPECT_EQ (occupied (scene_.solved(), test::kFree, 0), 0.0);
  }
}

TEST_F (LandingMapTest, AnotherStateTakesThePlaceOfTheFirst)
{
  const MotionState apart = onTheFreeTile();
  MotionState together = apart;
  together.body_of[test::kCovered] = 0;
  const DataTerm data = scene_.data();
  LandingMap renewed (data, {});
  for (const MotionState& state : {apart, together, apart}) {
    renewed.enter (state, std::vector<double> (48, 0.0), 2);
    for (int segment = 0; segment < 48; ++segment)
      for (const int body : {0, 1, 2})
        EXPECT_EQ (renewed.occupiedShare (data, segment, body, kCost),
                   occupied (state, segment, body));
  }
}

TEST_F (LandingMapTest, OutsideTheImageIsNoPlace)
{
  MotionState state = scene_.solved();
  for (const RigidPose& pose : {test::tilesAway (20, 0),
                                test::tilesAway (0, -20),
                                test::turnAbout ({0, 0, 0}, {0, 0, 0}, {0, 0, -5})}) {
    test::setApart (state, test::kCovered, pose);
    EXPECT_EQ (occupied (state, test::kCovered, state.body_of[test::kCovered]), 0.0);
  }
}

} // namespace
