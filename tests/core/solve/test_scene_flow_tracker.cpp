// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/other_place.h"
#include "support/standing_room.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/scene_flow_estimator.h>
#include <pcl_msf/scene_flow_tracker.h>

#include <cmath>
#include <cstring>
#include <map>

namespace {

using namespace pcl_msf;
using test::distanceToTruth;
using test::standingRoom;

constexpr int kFrames = 6;

SceneFlowTracker
makeTracker (const TrackerParameters& parameters)
{
  return SceneFlowTracker (parameters, {}, {}, {}, {});
}

TEST (SceneFlowTracker, FollowsTheCameraWithABoundedWindow)
{
  const test::AnalyticScene scene = standingRoom();
  TrackerParameters parameters;
  parameters.window = 3;
  SceneFlowTracker tracker = makeTracker (parameters);
  int frame = 0;
  for (const test::View& view : test::renderWindow (scene, kFrames)) {
    tracker.add (scene.frame (view));
    EXPECT_LE (tracker.frames(), 3);
    EXPECT_LT (distanceToTruth (scene, frame, tracker.cameraPose()),
               0.004 * (1 + frame));
    ++frame;
  }
  EXPECT_EQ (tracker.firstFrame(), 0) << "it still explains the frames";
  EXPECT_EQ (tracker.frameIndex (1), kFrames - 2);
  EXPECT_EQ (tracker.frameIndex (2), kFrames - 1);
  EXPECT_EQ (tracker.result().frames.size(), 3U);
  EXPECT_FALSE (tracker.sceneFlow().flow.empty());
}

/** Every segment of `before` lies in one segment of `after`. */
bool
onlyMerged (const cv::Mat& before, const cv::Mat& after)
{
  std::map<int, int> now;
  for (int y = 0; y < before.rows; ++y)
    for (int x = 0; x < before.cols; ++x) {
      const int merged = after.at<int> (y, x);
      if (now.emplace (before.at<int> (y, x), merged).first->second != merged)
        return false;
    }
  return true;
}

TEST (SceneFlowTracker, SegmentsMergeAndNeverSplit)
{
  const test::AnalyticScene scene = standingRoom();
  for (const bool merge : {true, false}) {
    TrackerParameters parameters;
    parameters.window = 3;
    parameters.merge_segments = merge;
    SceneFlowTracker tracker = makeTracker (parameters);
    cv::Mat labels;
    int first = 0;
    for (const test::View& view : test::renderWindow (scene, kFrames)) {
      tracker.add (scene.frame (view));
      ASSERT_EQ (tracker.firstFrame(), 0);
      const cv::Mat now = tracker.segments().labels();
      EXPECT_TRUE (labels.empty() || onlyMerged (labels, now));
      labels = now.clone();
      first = first == 0 ? tracker.segments().size() : first;
    }
    if (merge)
      EXPECT_LT (tracker.segments().size(), first);
    else
      EXPECT_EQ (tracker.segments().size(), first);
    EXPECT_LT (distanceToTruth (scene, kFrames - 1, tracker.cameraPose()), 0.02);
  }
}

TEST (SceneFlowTracker, SameFramesSameBits)
{
  const test::AnalyticScene scene = standingRoom();
  std::vector<cv::Mat> flows;
  for (const int window : {3, 0})
    for (const unsigned threads : {1U, 2U}) {
      SolverParameters solver;
      solver.threads = threads;
      TrackerParameters parameters;
      parameters.window = window;
      SceneFlowTracker tracker (parameters, {}, {}, solver, {});
      for (const test::View& view : test::renderWindow (scene, 4))
        tracker.add (scene.frame (view));
      flows.push_back (tracker.sceneFlow().flow);
    }
  for (const int first : {0, 2}) {
    int different = 0;
    for (int y = 0; y < flows[0].rows; ++y)
      for (int x = 0; x < flows[0].cols; ++x)
        different += std::memcmp (&flows[first].at<cv::Vec2f> (y, x),
                                  &flows[first + 1].at<cv::Vec2f> (y, x),
                                  sizeof (cv::Vec2f)) != 0;
    EXPECT_EQ (different, 0);
  }
}

TEST (SceneFlowTracker, BeginsAnewWhenReferenceAndFrameShowTooLittleOfEachOther)
{
  const test::AnalyticScene scene = test::roomWithBox();
  for (double TrackerParameters::*least :
       {&TrackerParameters::least_visible, &TrackerParameters::least_explained}) {
    TrackerParameters parameters;
    parameters.window = 4;
    parameters.*least = 1.0; // never satisfied
    SceneFlowTracker tracker = makeTracker (parameters);
    int frame = 0;
    for (const test::View& view : test::renderWindow (scene, 4)) {
      tracker.add (scene.frame (view));
      EXPECT_LT (distanceToTruth (scene, frame, tracker.cameraPose()),
                 0.004 * (1 + frame));
      ++frame;
    }
    EXPECT_EQ (tracker.frames(), 2);
    EXPECT_EQ (tracker.firstFrame(), 2);
  }
}

/** Does a solve begin with optical flow, and not where bodies should be? */
bool
searched (const SceneFlow& flow)
{
  bool coarse = false;
  for (const IterationRecord& record : flow.report.history)
    coarse |= record.level > 1 && record.terms.flow > 0.0;
  return coarse;
}

TEST (SceneFlowTracker, FollowsFromWhereTheBodiesShouldBe)
{
  const test::AnalyticScene scene = standingRoom();
  SceneFlowTracker tracker = makeTracker ({});
  int frame = 0;
  for (const test::View& view : test::renderWindow (scene, kFrames)) {
    tracker.add (scene.frame (view));
    EXPECT_LT (distanceToTruth (scene, frame, tracker.cameraPose()),
               0.004 * (1 + frame));
    EXPECT_EQ (tracker.firstFrame(), 0);
    if (frame > 0) {
      EXPECT_TRUE (tracker.sceneFlow().report.converged);
      EXPECT_EQ (tracker.frames(), 2);
      EXPECT_EQ (tracker.frameIndex (1), frame);
      EXPECT_EQ (searched (tracker.sceneFlow()), frame == 1);
    }
    ++frame;
  }
}

TEST (SceneFlowTracker, ANewReferenceFollowsTheBodiesOfTheLast)
{
  const test::AnalyticScene scene = test::roomWithBox();
  TrackerParameters parameters;
  parameters.least_visible = 1.0; // never satisfied
  SceneFlowTracker tracker = makeTracker (parameters);
  int frame = 0;
  for (const test::View& view : test::renderWindow (scene, 4)) {
    tracker.add (scene.frame (view));
    EXPECT_LT (distanceToTruth (scene, frame, tracker.cameraPose()),
               0.004 * (1 + frame));
    EXPECT_EQ (tracker.firstFrame(), std::max (0, frame - 1));
    if (frame > 0) {
      EXPECT_EQ (searched (tracker.sceneFlow()), frame == 1);
    }
    ++frame;
  }
}

TEST (SceneFlowTracker, FollowsACameraThatJumps)
{
  const test::AnalyticScene scene = standingRoom();
  const auto views = test::renderWindow (scene, 9);
  SceneFlowTracker tracker = makeTracker ({});
  for (const int frame : {0, 1, 2, 8})
    tracker.add (scene.frame (views[frame]));
  EXPECT_TRUE (tracker.sceneFlow().report.converged);
  EXPECT_EQ (tracker.firstFrame(), 0);
  EXPECT_FALSE (searched (tracker.sceneFlow()));
  EXPECT_LT (distanceToTruth (scene, 8, tracker.cameraPose()), 0.004);
}

RgbdFrame
coveredLens (const test::AnalyticScene& scene)
{
  const cv::Size size (scene.width, scene.height);
  return RgbdFrame::fromImages (cv::Mat (size, CV_32FC1, cv::Scalar (0.08)),
                                cv::Mat (size, CV_32FC1, cv::Scalar (0.3)),
                                scene.camera);
}

TEST (SceneFlowTracker, PassesOverACoveredLens)
{
  const test::AnalyticScene scene = standingRoom();
  const auto views = test::renderWindow (scene, 5);
  SceneFlowTracker tracker = makeTracker ({});
  for (int frame = 0; frame < 5; ++frame) {
    const test::View& view = views[frame];
    const bool covered = frame == 3;
    tracker.add (covered ? coveredLens (scene) : scene.frame (view));
    if (frame > 0) {
      EXPECT_EQ (tracker.sceneFlow().report.converged, !covered);
    }
  }
  EXPECT_EQ (tracker.firstFrame(), 0);
  EXPECT_LT (distanceToTruth (scene, 4, tracker.cameraPose()), 0.02);
}

TEST (SceneFlowTracker, BeginsAnewInAnotherPlace)
{
  const test::AnalyticScene scene = standingRoom();
  SceneFlowTracker tracker = makeTracker ({});
  for (const test::View& view : test::renderWindow (scene, 3))
    tracker.add (scene.frame (view));
  std::vector<bool> known;
  for (int i = 0; i < 3; ++i) {
    tracker.add (test::otherPlace (scene));
    known.push_back (tracker.sceneFlow().report.converged);
  }
  EXPECT_THAT (known, testing::ElementsAre (false, true, true));
  EXPECT_EQ (tracker.firstFrame(), 3);
}

TEST (SceneFlowTracker, RefusesToMergeSegmentsWithoutAWindow)
{
  TrackerParameters parameters;
  parameters.merge_segments = true;
  std::string why;
  EXPECT_FALSE (parameters.isValid (&why));
  EXPECT_THAT (why, testing::HasSubstr ("window"));
  parameters.window = 2;
  EXPECT_TRUE (parameters.isValid());
}

TEST (SceneFlowTracker, RefusesAFrameWithoutColorAmongColoredOnes)
{
  const test::AnalyticScene scene = standingRoom();
  const std::vector<test::View> views = test::renderWindow (scene, 2);
  SceneFlowTracker tracker = makeTracker ({});
  tracker.add (scene.frame (views[0]));
  EXPECT_THROW (
      tracker.add (RgbdFrame::fromImages (cv::Mat(), views[1].depth, scene.camera)),
      InvalidInput);
  EXPECT_EQ (tracker.frames(), 1);
}

TEST (SceneFlowTracker, WindowOfTwoGoesFromFrameToFrame)
{
  const test::AnalyticScene scene = standingRoom();
  TrackerParameters parameters;
  parameters.window = 2;
  SceneFlowTracker tracker = makeTracker (parameters);
  std::vector<RgbdFrame> frames;
  RigidPose last_step;
  for (const test::View& view : test::renderWindow (scene, 3)) {
    frames.push_back (scene.frame (view));
    tracker.add (frames.back());
    if (frames.size() < 2)
      continue;
    const SceneFlow pair = SceneFlowEstimator().estimate (
        frames[frames.size() - 2], frames.back(), tracker.segments(), last_step);
    EXPECT_EQ (cv::norm (tracker.sceneFlow().flow, pair.flow, cv::NORM_INF), 0.0);
    EXPECT_EQ (tracker.sceneFlow().report.iterations, pair.report.iterations);
    last_step = pair.dominant_motion;
  }
  EXPECT_EQ (tracker.frames(), 2);
  EXPECT_EQ (tracker.firstFrame(), 1);
}

TEST (SceneFlowTracker, RefusesBadInputAndStaysAsItWas)
{
  TrackerParameters bad;
  bad.window = 1;
  EXPECT_THROW (makeTracker (bad), InvalidInput);
  const test::AnalyticScene scene = test::roomWithBox();
  SceneFlowTracker tracker = makeTracker ({});
  EXPECT_THROW (tracker.add (RgbdFrame{}), InvalidInput);
  const auto views = test::renderWindow (scene, 2);
  tracker.add (scene.frame (views[0]));
  test::AnalyticScene small = scene;
  small.width = 80;
  small.height = 60;
  EXPECT_THROW (tracker.add (small.frame (small.render (true))), InvalidInput);
  EXPECT_EQ (tracker.frames(), 1);
  tracker.add (scene.frame (views[1]));
  EXPECT_EQ (tracker.frames(), 2);
  tracker.reset();
  EXPECT_EQ (tracker.frames(), 0);
  EXPECT_EQ (tracker.cameraPose().parameters, RigidPose{}.parameters);
}

TEST (SceneFlowTracker, LeavesImagesOutAndFollowsAsItDoesWithThem)
{
  const test::AnalyticScene scene = standingRoom();
  for (const int window : {0, 3}) {
    TrackerParameters parameters;
    parameters.window = window;
    SceneFlowTracker with = makeTracker (parameters);
    parameters.dense = false;
    SceneFlowTracker without = makeTracker (parameters);
    for (const test::View& view : test::renderWindow (scene, 4)) {
      const RgbdFrame frame = scene.frame (view);
      with.add (frame);
      without.add (frame);
      EXPECT_EQ (with.cameraPose().matrix(), without.cameraPose().matrix());
    }
    const SceneFlow& flow = without.sceneFlow();
    EXPECT_TRUE (flow.report.converged);
    EXPECT_EQ (flow.groups, with.sceneFlow().groups);
    EXPECT_EQ (flow.segments.size(), with.sceneFlow().segments.size());
    for (const cv::Mat& image : {flow.labels,
                                 flow.points,
                                 flow.displacement,
                                 flow.flow,
                                 flow.visibility,
                                 flow.flow_deviation,
                                 flow.displacement_deviation})
      EXPECT_TRUE (image.empty());
  }
}

} // namespace
