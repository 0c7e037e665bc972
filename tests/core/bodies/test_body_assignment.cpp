// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/bodies/body_assignment.h"
#include "support/covered_wall.h"

namespace {

using namespace pcl_msf;

constexpr double kSeparation = 0.3;
constexpr int kRounds = 3;
constexpr int kStray = 19; // amid the left half

AssignmentRules
rulesOf (bool hides)
{
  AssignmentRules rules;
  rules.hides = hides;
  return rules;
}

/** Lets the segments of a pair of frames choose. */
int
reassignTiles (const test::TiledScene& scene,
               const DataTerm& data,
               int threads,
               MotionState& state,
               AssignmentTuning tuning = {})
{
  WindowState window (state);
  tuning.separation = kSeparation;
  tuning.prior = 0.0;
  tuning.rounds = kRounds;
  const int changes = reassignBodies (
      scene.terms (data), scene.links(), tuning, rulesOf (true), threads, window);
  state = window.ofPair (0);
  return changes;
}

class BodyAssignment : public testing::Test {
protected:
  int
  reassign (MotionState& state, int threads = 1)
  {
    return reassignTiles (scene_, data_, threads, state);
  }

  test::TiledScene scene_{test::foldedWall()};
  DataTerm data_{scene_.data()};
};

TEST_F (BodyAssignment, RightOnesStay)
{
  MotionState state = scene_.solved();
  EXPECT_EQ (reassign (state), 0);
  EXPECT_EQ (state.body_of, scene_.solved().body_of);
}

TEST_F (BodyAssignment, StraySegmentComesHome)
{
  MotionState state = scene_.solved();
  ASSERT_EQ (state.body_of[kStray], 0);
  state.body_of[kStray] = 1;
  EXPECT_EQ (reassign (state), 1);
  EXPECT_EQ (state.body_of, scene_.solved().body_of);
}

TEST_F (BodyAssignment, BodyOfALostSegmentDisappears)
{
  MotionState state = scene_.solved();
  RigidPose lost;
  lost.parameters = {0.1, 0.2, -0.1, 0.3, -0.2, 0.4};
  state.poses.push_back (lost);
  state.body_of[kStray] = 2;
  EXPECT_EQ (reassign (state), 1);
  EXPECT_EQ (state.poses.size(), 2u);
  EXPECT_TRUE (test::samePartition (state.body_of, scene_.bodyOf()));
}

TEST_F (BodyAssignment, SegmentWithAMotionOfItsOwnKeepsIt)
{
  // The other half's true motion, which no other segment has: its data decide.
  MotionState state = scene_.solved();
  for (std::size_t k = 0; k < state.body_of.size(); ++k)
    if (scene_.bodyOf()[k] == 1)
      state.body_of[k] = static_cast<int> (k) == 20 ? 1 : 0;
  reassign (state);
  EXPECT_EQ (state.poseOf (20).parameters, scene_.solved().poses[1].parameters);
}

TEST_F (BodyAssignment, ABodyOfFewSegmentsIsTriedByItsNeighboursAlone)
{
  // Half of the wall waits for a motion that one of its segments has.
  WindowState one (scene_.solved());
  for (std::size_t k = 0; k < one.body_of.size(); ++k)
    one.body_of[k] = k == 20 ? 1 : 0;
  AssignmentTuning tuning;
  tuning.separation = kSeparation;
  tuning.prior = 0.0;
  tuning.rounds = 1;
  int found[2];
  for (const int least : {1, 5}) {
    WindowState state = one;
    tuning.least_share = least / 48.0;
    found[least / 5] = reassignBodies (
        scene_.terms (data_), scene_.links(), tuning, rulesOf (true), 1, state);
  }
  EXPECT_GT (found[1], 0);
  EXPECT_GE (found[0], 2 * found[1]);
}

TEST_F (BodyAssignment, SameForAnyNumberOfThreads)
{
  std::vector<int> first;
  for (const int threads : {1, 2, 5}) {
    MotionState state = scene_.solved();
    for (std::size_t k = 0; k < state.body_of.size(); k += 3)
      state.body_of[k] = 1 - state.body_of[k];
    EXPECT_GT (reassign (state, threads), 0);
    if (first.empty())
      first = state.body_of;
    EXPECT_EQ (state.body_of, first);
  }
}

/** A tile of the wall that the plate comes to hide, without texture, in a body of its
 * own. */
class CoveredTile : public testing::Test {
protected:
  CoveredTile() { test::wipeTexture (scene_.pixels(), test::kCovered, test::kCovered); }

  int
  reassign (MotionState& state, int threads = 1)
  {
    return reassignTiles (scene_, scene_.data(), threads, state);
  }

  test::TiledScene scene_{test::coveredWall()};
};

TEST_F (CoveredTile, CannotHideOnAnOccupiedPlace)
{
  // All that it sees there fits; but that is where another tile of the wall is.
  MotionState state = scene_.solved();
  test::setApart (state, test::kCovered, test::tilesAway (0, 1));
  EXPECT_EQ (reassign (state), 1);
  EXPECT_EQ (state.body_of, scene_.solved().body_of);
}

TEST_F (CoveredTile, KeepsAFreePlace)
{
  // The wall below looks different from what is there: it must have gone elsewhere.
  MotionState state = scene_.solved();
  const RigidPose away = test::tilesAway (0, 1);
  test::setApart (state, test::kCovered, away);
  SegmentPixels& pixels = scene_.pixels();
  for (int i = pixels.begin[test::kFree]; i < pixels.begin[test::kFree + 1]; ++i)
    pixels.intensity[i] += 0.9f;
  reassign (state);
  EXPECT_EQ (state.poseOf (test::kCovered).parameters, away.parameters);
}

TEST_F (CoveredTile, IsNotDrivenOutByWhatFitsClearlyWorse)
{
  // The wall below is there, and looks it: just not beyond what noise may do.
  SegmentPixels& pixels = scene_.pixels();
  for (int i = pixels.begin[test::kFree]; i < pixels.begin[test::kFree + 1]; ++i)
    if (pixels.brightness_scale[i] > 0.0f)
      pixels.intensity[i] += 2.2f / pixels.brightness_scale[i];
  const DataTerm data = scene_.data();
  const RigidPose away = test::tilesAway (0, 1);
  AssignmentTuning tuning;
  for (const bool owns : {false, true}) {
    MotionState state = scene_.solved();
    test::setApart (state, test::kCovered, away);
    tuning.landings.worse = owns ? 100.0 : 0.3;
    reassignTiles (scene_, data, 1, state, tuning);
    EXPECT_EQ (state.body_of[test::kCovered] == 0, owns);
  }
}

TEST_F (CoveredTile, SmallBodyThatIsSeenKeepsItsMotion)
{
  // The plate lands where the covered tile would be, were it not hidden.
  MotionState state = scene_.solved();
  EXPECT_EQ (reassign (state), 0);
  EXPECT_EQ (state.body_of[test::kPlateTile], 1);
}

TEST_F (CoveredTile, LeavesTheImageWithTheLargestBody)
{
  // Two columns of tiles go out of view. That no neighbour of the outer one is left in
  // the image does not speak against it; the place it fits by chance is no better.
  constexpr int kOuter = 24;
  MotionState state = scene_.solved();
  state.poses[0] = test::tilesAway (-2, 0);
  test::setApart (state, kOuter, test::tilesAway (0.4, 0.3));
  EXPECT_GT (reassign (state), 0);
  EXPECT_EQ (state.body_of[kOuter], state.body_of[test::kWallTile]);
}

TEST_F (CoveredTile, IsNoEvidenceAgainstTheLargestBodyThatHidesIt)
{
  // The wall goes left and up, a tile at its left edge out of view; it fits where it
  // is. Earlier frames, which saw it, are no such case.
  constexpr int kOut = 25;
  for (const bool hides : {false, true}) {
    WindowState state (scene_.solved());
    state.poses[0][0] = test::tilesAway (-4, -3);
    state.body_of[kOut] = static_cast<int> (state.poses[0].size());
    state.poses[0].emplace_back();
    AssignmentTuning tuning;
    tuning.separation = kSeparation;
    tuning.prior = 1e9;
    tuning.rounds = 1;
    tuning.least_share = 1.0; // no other tile tries its motion
    reassignBodies (scene_.terms (scene_.data()),
                    scene_.links(),
                    tuning,
                    rulesOf (hides),
                    1,
                    state);
    const bool joins = state.body_of[kOut] == state.body_of[test::kWallTile];
    EXPECT_EQ (joins, hides);
  }
}

TEST_F (CoveredTile, TheLargestBodyIsTheOneOfMostPointsThatAreSeen)
{
  // Most tiles hide out of view, which nothing contradicts; the rest has what is seen.
  WindowState state (scene_.solved());
  state.poses[0].push_back (test::tilesAway (-9, 0));
  for (int k = 0; k < 48; ++k)
    if (k / 8 >= 2)
      state.body_of[k] = 2;
  AssignmentTuning tuning;
  tuning.separation = kSeparation;
  tuning.prior = 1e9;
  reassignBodies (
      scene_.terms (scene_.data()), scene_.links(), tuning, rulesOf (true), 1, state);
  ASSERT_EQ (state.bodies(), 1);
  EXPECT_EQ (state.poses[0][0].parameters, scene_.solved().poses[0].parameters);
}

TEST_F (CoveredTile, SameForAnyNumberOfThreads)
{
  std::vector<int> first;
  for (const int threads : {1, 2, 5}) {
    MotionState state = scene_.solved();
    for (int k = 2; k < 48; k += 5)
      test::setApart (state, k, test::tilesAway (0.1 * (k % 4), k < 40 ? 1 : -1));
    test::wipeTexture (scene_.pixels(), 0, 47);
    EXPECT_GT (reassign (state, threads), 0);
    if (first.empty())
      first = state.body_of;
    EXPECT_EQ (state.body_of, first);
  }
}

} // namespace
