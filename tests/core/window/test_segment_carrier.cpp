// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/window/segment_carrier.h"
#include "support/analytic_scene.h"

namespace {

using namespace pcl_msf;

NoiseModel
exact ()
{
  NoiseModel noise;
  noise.inverse_depth = 1e-4;
  return noise;
}

TEST (SegmentCarrier, LabelsAreThoseOfTheMovedBodies)
{
  const test::AnalyticScene scene = test::roomWithBox();
  const test::View before = scene.render (false);
  const test::View after = scene.render (true);
  const RgbdFrame reference = scene.frame (before);
  const RgbdFrame frame = scene.frame (after);
  const cv::Mat labels = carryLabels (reference.levels()[0],
                                      before.body,
                                      MotionState::fromSegments (scene.motions, 0),
                                      frame.levels()[0],
                                      exact(),
                                      {});
  int known = 0;
  int right = 0;
  int wrong_on_box = 0;
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      if (labels.at<int> (y, x) < 0)
        continue;
      ++known;
      right += labels.at<int> (y, x) == after.body.at<int> (y, x);
      wrong_on_box += after.body.at<int> (y, x) == 1 && labels.at<int> (y, x) != 1;
    }
  EXPECT_GT (known, 0.9 * labels.total());
  EXPECT_GT (right, 0.995 * known);
  EXPECT_LE (wrong_on_box, 3);
}

TEST (SegmentCarrier, UncoveredSurfacesBearNoLabel)
{
  // A wall, and a plate in front of it that jumps by its own width to the right.
  test::AnalyticScene scene;
  scene.quads.push_back ({{-4, -3, 3.0}, {8, 0, 0}, {0, 6, 0}, 0, 0.3});
  scene.quads.push_back ({{-0.2, -0.2, 1.5}, {0.4, 0, 0}, {0, 0.4, 0}, 1, 1.0});
  scene.motions.resize (2);
  scene.motions[1].parameters[3] = 0.5;
  const test::View before = scene.render (false);
  const RgbdFrame reference = scene.frame (before);
  const RgbdFrame frame = scene.frame (scene.render (true));
  const cv::Mat labels = carryLabels (reference.levels()[0],
                                      before.body,
                                      MotionState::fromSegments (scene.motions, 0),
                                      frame.levels()[0],
                                      exact(),
                                      {});
  EXPECT_EQ (labels.at<int> (60, 80), -1) << "the wall that the plate hid";
  EXPECT_EQ (labels.at<int> (60, 130), 1) << "the plate";
  EXPECT_EQ (labels.at<int> (10, 10), 0) << "the wall";
}

TEST (SegmentCarrier, SurfacesThatAreNotThereBearNoLabel)
{
  test::AnalyticScene scene;
  scene.quads.push_back ({{-4, -3, 3.0}, {8, 0, 0}, {0, 6, 0}, 0, 0.3});
  scene.motions.resize (1);
  const test::View before = scene.render (false);
  const RgbdFrame reference = scene.frame (before);
  RigidPose nearer; // says that the wall comes nearer, which the frame does not show
  nearer.parameters[5] = -0.5;
  const cv::Mat labels = carryLabels (reference.levels()[0],
                                      before.body,
                                      MotionState::fromSegments ({nearer}, 0),
                                      reference.levels()[0],
                                      exact(),
                                      {});
  EXPECT_EQ (cv::countNonZero (labels >= 0), 0);
}

} // namespace
