// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/solve/window_start.h"
#include "support/window_scene.h"
#include <pcl_msf/oversegmentation.h>

#include <vector>

namespace {

using namespace pcl_msf;

constexpr int kFrames = 4;

/** What a window of the room and its box begins with. */
struct Start {
  test::AnalyticScene scene{test::roomWithBox()};
  std::vector<RgbdFrame> frames;
  FramePairs pairs;
  int segments{0};
  WindowState state;

  Start (bool colored, int reference) : pairs (kFrames, reference)
  {
    for (const test::View& view : test::renderWindow (scene, kFrames))
      frames.push_back (RgbdFrame::fromImages (
          colored ? view.color : cv::Mat(), view.depth, scene.camera));
    const Oversegmentation cut = Oversegmentation::fromFrame (frames[reference]);
    segments = cut.size();
    const EnergyParameters energy;
    const SolverParameters solver;
    const Tuning tuning;
    WindowStart start (frames, pairs, cut, energy, solver, tuning);
    start.run ({}, {});
    state = start.state();
  }
};

/** Of the background's corner point, metres. */
double
distanceToTruth (const Start& start, int pair)
{
  const Eigen::Vector3d point (0.3, -0.2, 2.5);
  const Eigen::Vector3d truth =
      test::motionBetween (
          start.scene, 0, start.pairs[pair].from, start.pairs[pair].to) *
      point;
  const RigidPose& found = start.state.poses[pair][start.state.largestBody()];
  return (found.rotation() * point + found.translation() - truth).norm();
}

TEST (WindowStart, WhatMovesAsOneIntoAllFramesIsOneBody)
{
  for (const int reference : {0, 1, kFrames - 1}) {
    const Start start (true, reference);
    EXPECT_GE (start.state.bodies(), 2) << "the room and its box";
    EXPECT_LT (start.state.bodies(), start.segments / 2);
    for (int p = 0; p < start.pairs.count(); ++p)
      EXPECT_LT (distanceToTruth (start, p), 0.004) << "pair " << p;
  }
}

TEST (WindowStart, DepthAloneLeavesSegmentsApart)
{
  const Start start (false, 0);
  EXPECT_EQ (start.state.bodies(), start.segments);
}

} // namespace
