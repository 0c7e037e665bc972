// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/result/segment_results.h"
#include "support/bending_wall.h"

namespace {

using namespace pcl_msf;
using test::BendingWall;
using test::ramp;
using test::WallShift;

constexpr double kSlide = 4.0;     // pixels
constexpr double kTogether = 0.95; // lifting weight that joins

/** A wall whose right columns slide by kSlide against the left ones, over the width of
 * a tile (soft) or at once (sharp); both sides are bodies. */
class SlidingHalf {
public:
  SlidingHalf (int columns, int rows, int right_columns, bool soft)
  : wall_ (columns,
           rows,
           [=] (double x) {
             const double seam = 20.0 * (columns - right_columns) - 0.5;
             const double share =
                 soft ? ramp (x, seam - 10.0, seam + 10.0) : (x < seam ? 0.0 : 1.0);
             return WallShift{kSlide * share, 0.0};
           })
  , state_ (wall_.truth())
  {
    const MotionState tiles = state_;
    state_.poses = {tiles.poses.front(), tiles.poses.back()};
    for (int k = 0; k < columns * rows; ++k)
      state_.body_of[k] = k % columns < columns - right_columns ? 0 : 1;
  }

  SceneFlow
  result (int threads = 1) const
  {
    const double scale = 0.5 * (wall_.pixels.brightness_count + wall_.pixels.icp_count);
    SceneFlow scene;
    ResultTuning tuning;
    tuning.groups.together = kTogether;
    tuning.groups.small_body = 8;
    fillSegments (
        wall_.data (state_), wall_.links, state_, scale, tuning, threads, scene);
    return scene;
  }

  BendingWall wall_;
  MotionState state_;
};

/** What the pairs between both bodies say; all the same. */
double
mixingAcross (const SlidingHalf& half, const SceneFlow& scene)
{
  double mixing = -1.0;
  for (const SegmentPair& pair : scene.pairs) {
    const bool inside =
        half.state_.body_of[pair.first] == half.state_.body_of[pair.second];
    if (inside) {
      EXPECT_EQ (pair.weight, 1.0);
      EXPECT_EQ (pair.mixing, 1.0);
      continue;
    }
    if (mixing >= 0.0) {
      EXPECT_EQ (pair.mixing, mixing);
    }
    mixing = pair.mixing;
  }
  return mixing;
}

TEST (MotionGroups, SmallBodiesOfASoftSurfaceAreOne)
{
  const SlidingHalf half (2, 1, 1, true);
  const SceneFlow scene = half.result();
  EXPECT_EQ (mixingAcross (half, scene), 1.0);
  EXPECT_EQ (scene.pairs[0].weight, 0.0);
  EXPECT_EQ (scene.groups, 1);
  EXPECT_EQ (scene.segments[0].group, 0);
  EXPECT_EQ (scene.segments[1].group, 0);
}

TEST (MotionGroups, SmallBodiesThatTearAreTwo)
{
  const SlidingHalf half (2, 1, 1, false);
  const SceneFlow scene = half.result();
  EXPECT_EQ (mixingAcross (half, scene), 0.0);
  EXPECT_EQ (scene.groups, 2);
  EXPECT_NE (scene.segments[0].group, scene.segments[1].group);
}

TEST (MotionGroups, JointOfALargeBodyStaysOne)
{
  // Eight tiles a side are small, nine are large, and one large side is enough.
  EXPECT_EQ (SlidingHalf (4, 4, 2, true).result().groups, 1);
  EXPECT_EQ (SlidingHalf (6, 3, 3, true).result().groups, 2);
  EXPECT_EQ (SlidingHalf (4, 3, 1, true).result().groups, 2);
}

TEST (MotionGroups, ConnectionsThatTheOptimizationKeptJoin)
{
  SlidingHalf half (6, 3, 3, true);
  half.state_.weights.assign (half.wall_.links.size(), kTogether + 0.01);
  EXPECT_EQ (half.result().groups, 1);
  half.state_.weights.assign (half.wall_.links.size(), kTogether - 0.01);
  EXPECT_EQ (half.result().groups, 2);
}

TEST (MotionGroups, LiftingWeightsMixWhereTheFramesSayNothing)
{
  SlidingHalf half (2, 1, 1, true);
  SegmentPixels& pixels = half.wall_.pixels;
  pixels.brightness_scale.assign (pixels.brightness_scale.size(), 0.0f);
  half.state_.weights[0] = 0.6;
  const SceneFlow scene = half.result();
  EXPECT_DOUBLE_EQ (mixingAcross (half, scene), 0.36);
  EXPECT_EQ (scene.groups, 2);
}

TEST (MotionGroups, TheLargestIsFirst)
{
  const SlidingHalf half (4, 3, 1, false);
  const SceneFlow scene = half.result();
  EXPECT_EQ (scene.dominant_group, 0);
  EXPECT_EQ (scene.segments[0].group, 0);
  EXPECT_EQ (scene.segments[3].group, 1);
  EXPECT_EQ (scene.dominant_motion.parameters, half.state_.poses[0].parameters);
}

TEST (MotionGroups, TheLargestIsTheOneOfMostPointsThatAreSeen)
{
  SlidingHalf half (4, 3, 1, false);
  half.state_.poses[0].parameters[3] = -20.0; // metres: out of view
  const SceneFlow scene = half.result();
  EXPECT_EQ (scene.segments[3].group, 0);
  EXPECT_EQ (scene.segments[0].group, 1);
  EXPECT_EQ (scene.dominant_motion.parameters, half.state_.poses[1].parameters);
}

TEST (MotionGroups, SameForAnyNumberOfThreads)
{
  const SlidingHalf half (6, 3, 3, true);
  const SceneFlow one = half.result();
  for (const int threads : {2, 5}) {
    const SceneFlow more = half.result (threads);
    ASSERT_EQ (more.pairs.size(), one.pairs.size());
    for (std::size_t i = 0; i < one.pairs.size(); ++i)
      EXPECT_EQ (more.pairs[i].mixing, one.pairs[i].mixing);
    for (std::size_t k = 0; k < one.segments.size(); ++k)
      EXPECT_EQ (more.segments[k].group, one.segments[k].group);
  }
}

} // namespace
