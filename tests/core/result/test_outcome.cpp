// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/result/outcome.h"
#include "support/other_place.h"
#include "support/room.h"
#include <gmock/gmock.h>
#include <pcl_msf/multiframe_estimator.h>
#include <pcl_msf/scene_flow_tracker.h>

#include <random>

// Success means that something is known.

namespace {

using namespace pcl_msf;
using testing::HasSubstr;

int
visiblePoints (const SceneFlow& flow)
{
  return cv::countNonZero (flow.visibility == pixelValue (Visibility::Visible));
}

void
expectNothingKnown (const SceneFlow& flow)
{
  EXPECT_EQ (flow.report.stop_reason, StopReason::NothingDetermined);
  EXPECT_STREQ (toString (flow.report.stop_reason), "nothing_determined");
  EXPECT_FALSE (flow.report.converged);
  EXPECT_THAT (flow.report.message, HasSubstr ("determined"));
  EXPECT_EQ (cv::countNonZero (cv::Mat (flow.flow == flow.flow).reshape (1)),
             0); // all NaN
  EXPECT_EQ (visiblePoints (flow), 0);
  EXPECT_EQ (flow.dominant_group, -1);
  for (const double parameter : flow.dominant_motion.parameters)
    EXPECT_EQ (parameter, 0.0);
}

class Outcome : public test::Room {
protected:
  /** A frame of the room's camera. */
  RgbdFrame
  frame (const cv::Mat& color, const cv::Mat& depth) const
  {
    return RgbdFrame::fromImages (color, depth, scene_.camera, {});
  }
  RgbdFrame
  coveredLens () const
  {
    const cv::Size size (scene_.width, scene_.height);
    return frame (cv::Mat (size, CV_32FC1, cv::Scalar (0.08)),
                  cv::Mat (size, CV_32FC1, cv::Scalar (0.3)));
  }
  RgbdFrame
  noise (bool with_color) const
  {
    std::mt19937 random (1);
    std::uniform_real_distribution<float> far (0.5f, 4.0f), bright (0.0f, 1.0f);
    cv::Mat color = scene_.render (true).color;
    cv::Mat depth = color.clone();
    depth.forEach<float> ([] (float& z, const int*) { z = 0.0f; });
    for (int i = 0; i < static_cast<int> (depth.total()); ++i) {
      depth.ptr<float>()[i] = far (random);
      if (with_color)
        color.ptr<float>()[i] = bright (random);
    }
    return frame (color, depth);
  }
  RgbdFrame
  otherRoom () const
  {
    return test::otherPlace (scene_);
  }
  /** Depth at every eighth pixel only. */
  RgbdFrame
  scattered (bool moved) const
  {
    const test::View view = scene_.render (moved);
    cv::Mat depth (view.depth.size(), CV_32FC1, cv::Scalar (0.0));
    for (int y = 0; y < depth.rows; y += 8)
      for (int x = 0; x < depth.cols; x += 8)
        depth.at<float> (y, x) = view.depth.at<float> (y, x);
    return frame (view.color, depth);
  }
  static SceneFlow
  align (const RgbdFrame& reference, const RgbdFrame& current)
  {
    SegmentationParameters cut;
    cut.segment_size = 16;
    return SceneFlowEstimator ({}, alone())
        .estimate (reference, current, Oversegmentation::fromFrame (reference, cut));
  }
};

TEST_F (Outcome, ACoveredLensDeterminesNothing)
{
  expectNothingKnown (align (reference_, coveredLens()));
  expectNothingKnown (align (coveredLens(), reference_));
}

TEST_F (Outcome, NoiseIsADifferentPlaceWithoutAWallOfVisiblePoints)
{
  for (const bool with_color : {true, false}) {
    const SceneFlow flow = align (reference_, noise (with_color));
    EXPECT_EQ (flow.report.stop_reason, StopReason::DifferentPlaces);
    EXPECT_STREQ (toString (flow.report.stop_reason), "different_places");
    EXPECT_FALSE (flow.report.converged);
    EXPECT_THAT (flow.report.message, HasSubstr ("different places"));
    EXPECT_LT (visiblePoints (flow), 0.05 * scene_.width * scene_.height);
  }
}

TEST_F (Outcome, NoiseHasNoPlaceInAnotherFrame)
{
  const SceneFlow flow = align (noise (true), reference_);
  EXPECT_EQ (flow.report.stop_reason, StopReason::DifferentPlaces);
  EXPECT_FALSE (flow.report.converged);
}

TEST_F (Outcome, AnotherRoomIsADifferentPlaceThoughItsWallsFit)
{
  const SceneFlow flow = align (reference_, otherRoom());
  EXPECT_GT (visiblePoints (flow), 0.3 * scene_.width * scene_.height);
  EXPECT_EQ (flow.report.stop_reason, StopReason::DifferentPlaces);
  EXPECT_FALSE (flow.report.converged);
}

/** Without colour what would hide the other frame's surfaces tells. */
TEST_F (Outcome, WithoutColourPointsBeforeWhatIsSeenTellAnotherPlace)
{
  const auto boxes = [this] (std::initializer_list<cv::Rect> places) {
    cv::Mat depth = scene_.render (false).depth.clone();
    float z = 0.7f;
    for (const cv::Rect& place : places)
      depth (place) = z += 0.1f;
    return frame ({}, depth);
  };
  const RgbdFrame here = boxes ({{5, 10, 40, 40}, {100, 60, 50, 50}});
  const SceneFlow flow =
      align (here, boxes ({{60, 5, 40, 40}, {20, 70, 60, 40}, {120, 10, 35, 60}}));
  EXPECT_GT (visiblePoints (flow), 0.3 * scene_.width * scene_.height);
  EXPECT_EQ (flow.report.stop_reason, StopReason::DifferentPlaces);
  EXPECT_THAT (flow.report.message, HasSubstr ("would hide what it sees"));
  EXPECT_TRUE (align (here, here).report.converged);
}

/** The room with other texture on the left part of its second picture. */
TEST_F (Outcome, MostOfTheTextureDecidesWhichPlaceItIs)
{
  const test::View view = scene_.render (true);
  const RgbdFrame other = otherRoom();
  const auto converges = [&] (double share) {
    test::View mixed = view;
    mixed.color = view.color.clone();
    const cv::Rect part (0, 0, static_cast<int> (share * scene_.width), scene_.height);
    cv::Mat strange;
    other.gray().convertTo (strange, CV_32F, 1.0 / 255.0);
    strange (part).copyTo (mixed.color (part));
    return align (reference_, scene_.frame (mixed)).report.converged;
  };
  EXPECT_TRUE (converges (0.3));
  EXPECT_FALSE (converges (0.8)) << "though all walls stand where they were";
}

TEST_F (Outcome, GainAndOffsetAreNoOtherPlace)
{
  test::View view = scene_.render (true);
  view.color = 0.2 + 0.5 * view.color;
  const SceneFlow flow = align (reference_, scene_.frame (view));
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
}

TEST_F (Outcome, ScatteredPointsDetermineNothing)
{
  expectNothingKnown (align (scattered (false), scattered (true)));
}

/** Parallel planes may slide along themselves; three walls hold each other. */
TEST_F (Outcome, ShapeAloneTellsMotionWhereItLeavesNoWayToSlide)
{
  const auto shape = [this] (const cv::Mat& depth) { return frame ({}, depth); };
  const SceneFlow room =
      align (shape (scene_.render (false).depth), shape (scene_.render (true).depth));
  EXPECT_TRUE (room.report.converged) << room.report.message;
  const auto planes = [&] (int left) {
    cv::Mat depth (scene_.height, scene_.width, CV_32FC1, cv::Scalar (2.0));
    depth (cv::Rect (left, 40, 50, 50)) = 1.0f;
    return shape (depth);
  };
  expectNothingKnown (align (planes (50), planes (53)));
}

TEST_F (Outcome, AFrameWithItselfConverges)
{
  const SceneFlow flow = align (reference_, reference_);
  EXPECT_TRUE (flow.report.converged);
  EXPECT_EQ (visiblePoints (flow), cv::countNonZero (flow.visibility));
}

TEST_F (Outcome, WhatStandsBeforeHalfOfTheSceneIsNoFailure)
{
  test::View view = scene_.render (true);
  view.depth (cv::Rect (0, 0, 90, scene_.height)) = 0.4f;
  view.color (cv::Rect (0, 0, 90, scene_.height)) = 0.5f;
  const SceneFlow flow = align (reference_, scene_.frame (view));
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  EXPECT_GT (cv::countNonZero (flow.visibility == pixelValue (Visibility::Occluded)),
             1000);
  // Without colour the three walls tell where the room is: the one at the left, which
  // is narrow, is left in view.
  view = scene_.render (true);
  view.depth (cv::Rect (scene_.width - 90, 0, 90, scene_.height)) = 0.4f;
  const SceneFlow shape =
      align (frame ({}, scene_.render (false).depth), frame ({}, view.depth));
  EXPECT_TRUE (shape.report.converged) << shape.report.message;
}

TEST_F (Outcome, AWindowAndItsMessageNameTheFrame)
{
  const MultiframeEstimator estimator ({}, alone(), {});
  const auto result =
      estimator.estimate ({reference_, current_, coveredLens()}, 0, segments_);
  EXPECT_EQ (result.report().stop_reason, StopReason::NothingDetermined);
  EXPECT_FALSE (result.report().converged);
  EXPECT_THAT (result.report().message, HasSubstr ("frame 2 of the window"));
  EXPECT_GT (visiblePoints (result.frames[1]), 10000); // the other frame is as good
}

TEST_F (Outcome, ATrackerSaysSoAndRecovers)
{
  TrackerParameters two;
  two.window = 2;
  SegmentationParameters cut;
  cut.segment_size = 16;
  SceneFlowTracker tracker (two, cut, {}, alone(), {});
  tracker.add (reference_);
  tracker.add (coveredLens());
  EXPECT_EQ (tracker.sceneFlow().report.stop_reason, StopReason::NothingDetermined);
  for (const double parameter : tracker.cameraPose().parameters)
    EXPECT_EQ (parameter, 0.0);
  tracker.add (reference_);
  EXPECT_FALSE (tracker.sceneFlow().report.converged);
  tracker.add (current_);
  EXPECT_TRUE (tracker.sceneFlow().report.converged);
}

TEST (Conclude, FlagReasonAndMessageAgree)
{
  const Judgement failure{StopReason::DifferentPlaces, "because", 3};
  for (const bool failed : {false, true})
    for (const auto cut_short : {StopReason::NotRun, StopReason::TimeLimit})
      for (const bool failing : {false, true}) {
        Report report;
        report.stop_reason = endOfSolve (true, failed);
        conclude (cut_short, {{}, failing ? failure : Judgement{}}, report);
        const bool well = !failed && !failing && cut_short == StopReason::NotRun;
        EXPECT_EQ (report.converged, well);
        EXPECT_EQ (report.stop_reason,
                   cut_short != StopReason::NotRun ? cut_short
                   : failed                        ? StopReason::NumericalFailure
                   : failing                       ? StopReason::DifferentPlaces
                                                   : StopReason::Converged);
        if (failing) {
          EXPECT_EQ (report.message, "frame 3 of the window: because");
        }
      }
  EXPECT_EQ (endOfSolve (false, false), StopReason::IterationLimit);
}

} // namespace
