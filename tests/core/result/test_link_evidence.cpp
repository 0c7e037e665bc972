// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/result/link_evidence.h"
#include "support/bending_wall.h"

#include <set>

namespace {

using namespace pcl_msf;
using test::BendingWall;
using test::ramp;
using test::WallShift;

// Middles of the two tiles of a pair.
constexpr double kLeft = 9.5;
constexpr double kRight = 29.5;
constexpr double kSlide = 4.0; // pixels
constexpr double kStep = 0.1;  // metres

/** What the frames say about two tiles side by side. */
LinkEvidence
evidenceOf (const BendingWall& wall, const MotionState& state)
{
  EXPECT_EQ (wall.links.size(), 1u);
  return classifyLinks (wall.data (state), wall.links, state, {}, 1)[0];
}

LinkEvidence
evidenceOf (const std::function<WallShift (double)>& shift)
{
  const BendingWall wall (2, 1, shift);
  return evidenceOf (wall, wall.truth());
}

TEST (SoftLinks, SurfaceThatStretchesIsSoft)
{
  EXPECT_EQ (evidenceOf ([] (double x) {
               return WallShift{kSlide * ramp (x, kLeft, kRight), 0.0};
             }),
             LinkEvidence::Soft);
}

TEST (SoftLinks, SurfaceThatTearsIsSharp)
{
  EXPECT_EQ (evidenceOf ([] (double x) {
               return WallShift{x < 19.75 ? 0.0 : kSlide, 0.0};
             }),
             LinkEvidence::Sharp);
}

TEST (SoftLinks, ShapeTellsWithoutTexture)
{
  const auto of = [] (const std::function<WallShift (double)>& shift) {
    BendingWall wall (2, 1, shift);
    wall.pixels.brightness_scale.assign (wall.pixels.brightness_scale.size(), 0.0f);
    return evidenceOf (wall, wall.truth());
  };
  EXPECT_EQ (of ([] (double x) {
               return WallShift{0.0, kStep * ramp (x, kLeft, kRight)};
             }),
             LinkEvidence::Soft);
  EXPECT_EQ (of ([] (double x) {
               return WallShift{0.0, x < 19.75 ? 0.0 : kStep};
             }),
             LinkEvidence::Sharp);
}

TEST (SoftLinks, NothingToSeeTellsNothing)
{
  // Without texture nothing tells how far a plane slid along itself.
  BendingWall wall (2, 1, [] (double x) {
    return WallShift{kSlide * ramp (x, kLeft, kRight), 0.0};
  });
  wall.pixels.brightness_scale.assign (wall.pixels.brightness_scale.size(), 0.0f);
  EXPECT_EQ (evidenceOf (wall, wall.truth()), LinkEvidence::None);
}

TEST (SoftLinks, EqualMotionsTellNothing)
{
  const auto stretches = [] (double x) {
    return WallShift{kSlide * ramp (x, kLeft, kRight), 0.0};
  };
  const BendingWall wall (2, 1, stretches);
  MotionState state = wall.truth();
  state.poses[1] = state.poses[0];
  EXPECT_EQ (evidenceOf (wall, state), LinkEvidence::None);
  state = wall.truth();
  state.body_of[1] = 0;
  EXPECT_EQ (evidenceOf (wall, state), LinkEvidence::None);
}

TEST (SoftLinks, FewPointsTellNothing)
{
  const auto stretches = [] (double x) {
    return WallShift{kSlide * ramp (x, kLeft, kRight), 0.0};
  };
  // Tiles seven apart: the points of neither lie on the way.
  const BendingWall wall (8, 1, stretches);
  const SegmentLink far{0, 7, Eigen::Vector3d::Zero(), 1.0};
  const MotionState state = wall.truth();
  EXPECT_EQ (classifyLinks (wall.data (state), {far}, state, {}, 1)[0],
             LinkEvidence::None);
}

/** Six by three tiles: the left four columns stretch, the last two tear off. */
TEST (SoftLinks, SameForAnyNumberOfThreads)
{
  const BendingWall wall (6, 3, [] (double x) {
    return WallShift{x < 79.75 ? 3.0 * ramp (x, 9.5, 69.5) : -2.0, 0.0};
  });
  const MotionState state = wall.truth();
  const auto one = classifyLinks (wall.data (state), wall.links, state, {}, 1);
  ASSERT_EQ (one.size(), wall.links.size());
  const std::set<LinkEvidence> kinds (one.begin(), one.end());
  EXPECT_EQ (kinds.size(), 3u);
  for (std::size_t i = 0; i < one.size(); ++i) {
    const SegmentLink& link = wall.links[i];
    const bool across = (link.first % 6 < 4) != (link.second % 6 < 4);
    EXPECT_NE (one[i], across ? LinkEvidence::Soft : LinkEvidence::Sharp)
        << link.first << " " << link.second;
  }
  for (const int threads : {2, 5})
    EXPECT_EQ (classifyLinks (wall.data (state), wall.links, state, {}, threads), one);
}

} // namespace
