// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
//
// Bodies over several pairs of frames: one scene of plates, seen in two pairs in which
// the plates may move differently.
#include <gtest/gtest.h>

#include "core/bodies/body_assignment.h"
#include "core/bodies/body_merging.h"
#include "core/data/body_noise.h"
#include "support/loose_plates.h"

namespace {

using namespace pcl_msf;
using Pass = DataTerm::Pass;

constexpr int kUnused = 1; // a pair that has poses but takes no part

/** Two pairs of frames from one reference, and one between that is not used. */
class TwoPairs {
public:
  TwoPairs (const test::AnalyticScene& first, const test::AnalyticScene& second)
  : first_ (first, test::kPlate)
  , second_ (second, test::kPlate)
  , first_data_ (first_.data())
  , second_data_ (second_.data())
  {
    state_ = WindowState (first_.truth());
    state_.poses.push_back (state_.poses[0]);
    for (std::size_t b = 0; b < state_.poses[kUnused].size(); ++b)
      state_.poses[kUnused][b].parameters[5] = static_cast<double> (b);
    state_.poses.push_back (second_.truth().poses);
    linearize();
  }

  void
  linearize ()
  {
    first_data_.sweep (state_.ofPair (0), Pass::Linearize);
    second_data_.sweep (state_.ofPair (2), Pass::Linearize);
  }

  /** Of both pairs; only the first one is used when `both` is false. */
  std::vector<PairTerms>
  terms (bool both = true) const
  {
    const double scale = first_.residualScale();
    return {{0, &first_data_, &first_data_, scale},
            {2, &second_data_, both ? &second_data_ : nullptr, scale}};
  }

  void
  merge ()
  {
    mergeBodies (terms(), 3, first_.links(), {}, state_);
  }

  int
  reassign (bool both)
  {
    return reassignBodies (terms (both), first_.links(), {}, {}, 1, state_);
  }

  test::TiledScene first_;
  test::TiledScene second_;
  DataTerm first_data_;
  DataTerm second_data_;
  WindowState state_;
};

TEST (WindowBodies, MergeWhatMovesAsOneInEveryPair)
{
  TwoPairs pairs (test::loosePlatesButTwo (10, 11), test::loosePlatesButTwo (10, 11));
  pairs.merge();
  EXPECT_EQ (pairs.state_.bodies(), 11);
  EXPECT_EQ (pairs.state_.body_of[10], pairs.state_.body_of[11]);
  for (const auto& poses : pairs.state_.poses)
    EXPECT_EQ (poses.size(), 11u);
}

TEST (WindowBodies, OnePairIsEnoughToTellBodiesApart)
{
  TwoPairs pairs (test::loosePlatesButTwo (10, 11), test::loosePlates());
  pairs.merge();
  EXPECT_EQ (pairs.state_.bodies(), 12);
}

TEST (WindowBodies, UnusedPairsKeepAPoseOfEveryBody)
{
  TwoPairs pairs (test::loosePlatesButTwo (10, 11), test::loosePlatesButTwo (10, 11));
  pairs.merge();
  for (int k = 0; k < 10; ++k)
    EXPECT_EQ (pairs.state_.poses[kUnused][pairs.state_.body_of[k]].parameters[5], k);
  const double merged = pairs.state_.poses[kUnused].back().parameters[5];
  EXPECT_TRUE (merged == 10.0 || merged == 11.0);
}

TEST (WindowBodies, CommonPosesAreThoseOfTheirOwnPair)
{
  test::AnalyticScene second = test::loosePlatesButTwo (10, 11);
  const RigidPose other = test::turnAbout ({0.5, 0.5, 2.4}, {0, 0, 0.02}, {0.1, 0, 0});
  second.motions[10] = second.motions[11] = other;
  TwoPairs pairs (test::loosePlatesButTwo (10, 11), second);
  pairs.merge();
  ASSERT_EQ (pairs.state_.bodies(), 11);
  const Eigen::Vector3d c = pairs.first_.pixels().centroid[10];
  const RigidPose first = test::loosePlatesButTwo (10, 11).motions[10];
  EXPECT_LT ((pairs.state_.ofPair (0).poseOf (10) * c - first * c).norm(), 1e-3);
  EXPECT_LT ((pairs.state_.ofPair (2).poseOf (10) * c - other * c).norm(), 1e-3);
}

TEST (WindowBodies, SegmentsAreAssignedByTheGivenPairs)
{
  // In the first pair plate 11 moves with the body beside it, in the second it does
  // not.
  test::AnalyticScene first = test::loosePlates();
  first.motions[9] = first.motions[10] = first.motions[11];
  test::AnalyticScene second = test::loosePlates();
  second.motions[9] = second.motions[10];
  for (const bool both : {true, false}) {
    TwoPairs pairs (first, second);
    pairs.state_.body_of[9] = 10;
    pairs.reassign (both);
    EXPECT_EQ (pairs.state_.body_of[9], pairs.state_.body_of[10]);
    EXPECT_EQ (pairs.state_.body_of[10] == pairs.state_.body_of[11], !both);
  }
}

TEST (WindowBodies, BodiesAreNumberedByTheirFirstSegment)
{
  WindowState state;
  state.body_of = {3, 1, 3, 0};
  state.poses.resize (2);
  for (auto& poses : state.poses)
    for (int b = 0; b < 4; ++b) {
      poses.emplace_back();
      poses.back().parameters[0] = 0.1 * b;
    }
  EXPECT_EQ (state.renumberBodies(), (std::vector<int>{3, 1, 0}));
  EXPECT_EQ (state.body_of, (std::vector<int>{0, 1, 0, 2}));
  ASSERT_EQ (state.bodies(), 3);
  for (const auto& poses : state.poses) {
    EXPECT_EQ (poses[0].parameters[0], 0.1 * 3);
    EXPECT_EQ (poses[2].parameters[0], 0.0);
  }
}

TEST (WindowBodies, TheLargestBodyHasMostSegments)
{
  WindowState state;
  state.poses = {{RigidPose{}, RigidPose{}, RigidPose{}}};
  EXPECT_EQ (state.largestBody(), 0);
  state.body_of = {2, 0, 1, 1, 0};
  EXPECT_EQ (state.largestBody(), 0) << "of equals the first";
  state.body_of.push_back (1);
  EXPECT_EQ (state.largestBody(), 1);
}

TEST (WindowBodies, RigidBodiesAreWeighedByAllTheirPairs)
{
  // One body of all plates: right in the first pair, right or wrong in two more.
  test::AnalyticScene still = test::loosePlates();
  for (RigidPose& motion : still.motions)
    motion = {};
  const auto sharpness = [&] (const test::AnalyticScene& second) {
    TwoPairs pairs (still, second);
    MotionState one = pairs.first_.truth();
    one.body_of.assign (one.body_of.size(), 0);
    one.poses.resize (1);
    WindowState state (one);
    state.poses.assign (3, one.poses);
    SegmentPixels pixels = pairs.first_.pixels();
    const float before = pixels.brightness_scale[0];
    std::vector<PairTerms> terms = pairs.terms();
    terms.push_back (terms.back());
    rescaleBodyNoise (terms, state, {}, 1, pixels);
    return pixels.brightness_scale[0] / before;
  };
  EXPECT_GT (sharpness (still), 2.0f);
  EXPECT_LT (sharpness (test::loosePlates()), 1.5f);
}

} // namespace
