// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/bodies/body_merging.h"
#include "support/loose_plates.h"

#include <random>

namespace {

using namespace pcl_msf;
using Pass = DataTerm::Pass;

constexpr MergeTuning kRules{10.0, 0.05};

/** The bodies of a pair of frames after merging. \param data linearized at the state */
MotionState
merged (const test::TiledScene& scene,
        const DataTerm& data,
        const std::vector<SegmentLink>& links,
        const MotionState& state)
{
  WindowState window (state);
  mergeBodies (scene.terms (data), 2, links, kRules, window);
  return window.ofPair (0);
}

/** Every segment a little off its motion, as estimates are: a tenth of a pixel. */
MotionState
estimated (const test::TiledScene& scene, const SegmentPixels& pixels)
{
  std::mt19937 generator (1);
  std::uniform_real_distribution<double> uniform (-1.0, 1.0);
  const auto vector = [&] (double scale) {
    return Eigen::Vector3d (scale * uniform (generator),
                            scale * uniform (generator),
                            scale * uniform (generator));
  };
  MotionState state = scene.truth();
  for (std::size_t k = 0; k < state.poses.size(); ++k)
    state.poses[k] =
        test::turnAbout (pixels.centroid[k], vector (2e-3), vector (1e-3)) *
        state.poses[k];
  return state;
}

TEST (BodyMerging, TwoMotionsMakeTwoBodies)
{
  test::TiledScene scene (test::foldedWall());
  DataTerm data = scene.data();
  const MotionState before = estimated (scene, scene.pixels());
  data.sweep (before, Pass::Linearize);
  const MotionState after = merged (scene, data, scene.links(), before);
  ASSERT_EQ (after.poses.size(), 2u);
  EXPECT_TRUE (test::samePartition (after.body_of, scene.bodyOf()));
  // The common poses are the true motions to a few hundredths of a pixel.
  for (int k = 0; k < scene.pixels().segments(); ++k) {
    const Eigen::Vector3d& c = scene.pixels().centroid[k];
    EXPECT_LT ((after.poseOf (k) * c - scene.truth().poseOf (k) * c).norm(), 1e-3) << k;
  }
  EXPECT_EQ (after.weights.size(), scene.links().size());
}

TEST (BodyMerging, SegmentWithoutTextureJoinsItsNeighbours)
{
  test::TiledScene scene (test::foldedWall());
  constexpr int kBlind = 20; // amid the right half: a plane alone leaves three freedoms
  SegmentPixels& pixels = scene.pixels();
  for (int i = pixels.begin[kBlind]; i < pixels.begin[kBlind + 1]; ++i)
    pixels.brightness_scale[i] = 0.0f;
  DataTerm data = scene.data();
  MotionState before = estimated (scene, pixels);
  // It slid along its plane, and nothing told it.
  const Eigen::Vector3d along = Eigen::Vector3d (6.0, 0, 1.6).normalized();
  RigidPose& blind = before.poses[kBlind];
  const Eigen::Vector3d slip = 0.05 * (blind.rotation() * along);
  for (int i = 0; i < 3; ++i)
    blind.parameters[3 + i] += slip[i];
  data.sweep (before, Pass::Linearize);
  const MotionState after = merged (scene, data, scene.links(), before);
  EXPECT_EQ (after.poses.size(), 2u);
  EXPECT_TRUE (test::samePartition (after.body_of, scene.bodyOf()));
  const Eigen::Vector3d& c = pixels.centroid[kBlind];
  EXPECT_LT ((after.poseOf (kBlind) * c - scene.truth().poseOf (kBlind) * c).norm(),
             2e-3);
}

TEST (BodyMerging, NothingMergesWhenAllDiffer)
{
  test::TiledScene scene (test::loosePlates(), test::kPlate);
  DataTerm data = scene.data();
  const MotionState before = scene.truth();
  data.sweep (before, Pass::Linearize);
  const MotionState after = merged (scene, data, scene.links(), before);
  EXPECT_EQ (after.poses.size(), 12u);
  EXPECT_EQ (after.body_of, before.body_of);
  for (int k = 0; k < 12; ++k)
    EXPECT_EQ (after.poseOf (k).parameters, before.poseOf (k).parameters);
}

/** How many bodies are left of the plates, without links or with all of them. */
MotionState
mergedPlates (const test::TiledScene& scene, bool linked)
{
  DataTerm data = scene.data();
  const MotionState before = scene.truth();
  data.sweep (before, Pass::Linearize);
  return merged (
      scene, data, linked ? scene.links() : std::vector<SegmentLink>{}, before);
}

TEST (BodyMerging, LargestBodiesTakeWhatTheyDoNotTouch)
{
  const test::TiledScene scene (test::loosePlatesButTwo (0, 11), test::kPlate);
  const MotionState after = mergedPlates (scene, false);
  EXPECT_EQ (after.poses.size(), 11u);
  EXPECT_EQ (after.body_of[0], after.body_of[11]);
}

TEST (BodyMerging, SmallBodiesMergeOnlyAlongLinks)
{
  // All plates are equally large: those with the lowest numbers count as the largest.
  const test::TiledScene scene (test::loosePlatesButTwo (10, 11), test::kPlate);
  EXPECT_EQ (mergedPlates (scene, false).poses.size(), 12u);
  const MotionState linked = mergedPlates (scene, true);
  EXPECT_EQ (linked.poses.size(), 11u);
  EXPECT_EQ (linked.body_of[10], linked.body_of[11]);
}

TEST (BodyMerging, WhatTheLargestTakeMayGrow)
{
  // Without links the tiles of each half still find each other, a few at a time.
  test::TiledScene scene (test::foldedWall());
  DataTerm data = scene.data();
  const MotionState before = estimated (scene, scene.pixels());
  data.sweep (before, Pass::Linearize);
  const MotionState after = merged (scene, data, {}, before);
  EXPECT_EQ (after.poses.size(), 2u);
  EXPECT_TRUE (test::samePartition (after.body_of, scene.bodyOf()));
}

TEST (BodyMerging, DifferentMotionsStayApartWithoutLinks)
{
  const test::TiledScene scene (test::loosePlates(), test::kPlate);
  EXPECT_EQ (mergedPlates (scene, false).poses.size(), 12u);
}

TEST (BodyMerging, BodiesWithoutSegmentsAreForgotten)
{
  test::TiledScene scene (test::foldedWall());
  DataTerm data = scene.data();
  MotionState before = scene.solved();
  before.poses.emplace_back();
  data.sweep (before, Pass::Linearize);
  const MotionState after = merged (scene, data, scene.links(), before);
  ASSERT_EQ (after.poses.size(), 2u);
  for (int k = 0; k < scene.pixels().segments(); ++k)
    EXPECT_EQ (after.poseOf (k).parameters, before.poseOf (k).parameters);
}

TEST (BodyMerging, MergedBodiesStayMerged)
{
  test::TiledScene scene (test::foldedWall());
  DataTerm data = scene.data();
  const MotionState before = scene.solved();
  data.sweep (before, Pass::Linearize);
  const MotionState after = merged (scene, data, scene.links(), before);
  EXPECT_EQ (after.poses.size(), 2u);
  EXPECT_TRUE (test::samePartition (after.body_of, before.body_of));
}

} // namespace
