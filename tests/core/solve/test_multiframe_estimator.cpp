// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/solve/window_solve.h"
#include "support/pose_matcher.h"
#include "support/window_scene.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/multiframe_estimator.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <cstring>

namespace {

using namespace pcl_msf;

/** Frames of the room with a box that both go on moving. */
struct Room {
  test::AnalyticScene scene{test::roomWithBox()};
  std::vector<test::View> views;
  std::vector<RgbdFrame> frames;

  explicit Room (int count) : views (test::renderWindow (scene, count))
  {
    for (const test::View& view : views)
      frames.push_back (scene.frame (view));
  }
  Oversegmentation
  segments (int reference) const
  {
    return Oversegmentation::fromFrame (frames[reference]);
  }
};

bool
sameBits (const cv::Mat& a, const cv::Mat& b)
{
  return a.size() == b.size() && a.type() == b.type() &&
         std::memcmp (a.data, b.data, a.total() * a.elemSize()) == 0;
}

/** Mean distance in pixels from the true flow over the points reported visible. */
double
meanError (const Room& room, int reference, int to, const SceneFlow& flow)
{
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < flow.flow.rows; ++y)
    for (int x = 0; x < flow.flow.cols; ++x) {
      if (flow.visibility.at<unsigned char> (y, x) != Visibility::Visible)
        continue;
      const int body = room.views[reference].body.at<int> (y, x);
      const Eigen::Vector3d q = test::motionBetween (room.scene, body, reference, to) *
                                room.scene.camera.backProject (
                                    x, y, room.views[reference].depth.at<float> (y, x));
      const Eigen::Vector2d uv = room.scene.camera.project (q);
      const cv::Vec2f f = flow.flow.at<cv::Vec2f> (y, x);
      sum += std::hypot (f[0] - (uv.x() - x), f[1] - (uv.y() - y));
      ++count;
    }
  return sum / std::max (1, count);
}

TEST (MultiframeEstimator, LightMayChangeFromFrameToFrame)
{
  Room room (3);
  for (const int f : {0, 1, 2}) {
    const test::View view = test::faded (room.views[f]);
    room.frames[f] = room.scene.frame (
        f == 1 ? test::underOtherLight (test::underOtherLight (view)) : view);
  }
  const MultiframeSceneFlow result =
      MultiframeEstimator().estimate (room.frames, 0, room.segments (0));
  EXPECT_LT (meanError (room, 0, 1, result.frames[1]), 0.012);
  EXPECT_LT (meanError (room, 0, 2, result.frames[2]), 0.012);
  EXPECT_TRUE (result.frames[1].report.light_changed);
}

/** Over how many pixels a pair's brightness errs alike, as its finest level takes it.
 */
double
brightnessArea (const Room& room)
{
  const Oversegmentation segments = room.segments (0);
  WindowSolve solve (room.frames, 0, segments, {}, {}, {}, currentTuning());
  EXPECT_EQ (solve.scene().brightness_area, 1.0) << "not known yet";
  solve.run ({});
  return solve.scene().brightness_area;
}

TEST (WindowSolve, FindsHowFarBrightnessErrsAlike)
{
  Room room (2);
  EXPECT_LT (brightnessArea (room), 6.0);
  test::View view = room.scene.render (true);
  for (int y = 0; y < view.color.rows; ++y)
    for (int x = 0; x < view.color.cols; ++x)
      view.color.at<float> (y, x) += static_cast<float> (
          0.1 * std::sin (0.25 * x + 1.0) * std::sin (0.25 * y)); // waves of 25 pixels
  room.frames[1] = room.scene.frame (view);
  EXPECT_GT (brightnessArea (room), 12.0);
}

TEST (MultiframeEstimator, TwoFramesAreAPair)
{
  const Room room (2);
  const Oversegmentation segments = room.segments (0);
  const SceneFlow pair =
      SceneFlowEstimator().estimate (room.frames[0], room.frames[1], segments);
  EXPECT_FALSE (pair.report.light_changed);
  const MultiframeSceneFlow window =
      MultiframeEstimator().estimate (room.frames, 0, segments);
  ASSERT_EQ (window.frames.size(), 2U);
  EXPECT_TRUE (sameBits (window.frames[1].flow, pair.flow));
  EXPECT_TRUE (sameBits (window.frames[1].displacement, pair.displacement));
  EXPECT_TRUE (sameBits (window.frames[1].visibility, pair.visibility));
  EXPECT_LT (meanError (room, 0, 1, window.frames[1]), 0.12);
  ASSERT_EQ (window.motions.size(), 1U);
  for (std::size_t k = 0; k < pair.segments.size(); ++k)
    EXPECT_EQ (window.motions[0].segments[k].parameters,
               pair.segments[k].current_from_reference.parameters);
  EXPECT_EQ (window.report().iterations, pair.report.iterations);
}

TEST (MultiframeEstimator, PriorOfABackgroundIsNoOtherMethodForTwoFrames)
{
  // Residuals tell every segment's body here: the prior has nothing to decide.
  const Room room (2);
  const Oversegmentation segments = room.segments (0);
  const SceneFlow pair =
      SceneFlowEstimator().estimate (room.frames[0], room.frames[1], segments);
  MultiframeParameters parameters;
  parameters.static_background = true;
  const MultiframeSceneFlow window =
      MultiframeEstimator ({}, {}, parameters).estimate (room.frames, 0, segments);
  EXPECT_TRUE (sameBits (window.frames[1].flow, pair.flow));
  EXPECT_EQ (window.report().iterations, pair.report.iterations);
}

TEST (MultiframeEstimator, FollowsBodiesOverThreeFramesFromAnyReference)
{
  const Room room (3);
  for (const int reference : {0, 1, 2}) {
    const MultiframeSceneFlow result = MultiframeEstimator().estimate (
        room.frames, reference, room.segments (reference));
    EXPECT_EQ (result.reference, reference);
    EXPECT_EQ (result.motions.size(), 3U);
    for (int k = 0; k < 3; ++k) {
      const SceneFlow& flow = result.frames[k];
      if (k == reference) {
        EXPECT_TRUE (flow.flow.empty());
        continue;
      }
      EXPECT_LT (meanError (room, reference, k, flow), 0.12)
          << reference << " to " << k;
      EXPECT_EQ (flow.segments.size(), result.motions[0].segments.size());
      EXPECT_EQ (flow.groups, result.frames[reference == 0 ? 1 : 0].groups);
    }
  }
}

TEST (MultiframeEstimator, PosesOfAllPairsAgreeAndTermsAddUp)
{
  const Room room (3);
  const Oversegmentation segments = room.segments (0);
  const MultiframeSceneFlow result =
      MultiframeEstimator().estimate (room.frames, 0, segments);
  const std::vector<IterationRecord>& history = result.report().history;
  ASSERT_FALSE (history.empty());
  for (const IterationRecord& record : history) {
    EXPECT_NEAR (record.terms.total(), record.cost, 0.05 * record.cost);
    EXPECT_GT (record.terms.concatenation, 0.0);
  }
  EXPECT_GE (history.back().energy, 1) << "rounds have energies of their own";
  for (int k = 0; k < segments.size(); k += 7) {
    const Eigen::Vector3d p = result.frames[1].segments[k].centroid;
    const Eigen::Vector3d direct = result.poseBetween (0, 2, k) * p;
    const Eigen::Vector3d chained =
        result.poseBetween (1, 2, k) * (result.poseBetween (0, 1, k) * p);
    EXPECT_LT ((direct - chained).norm(), 0.01);
    const Eigen::Vector3d back =
        result.poseBetween (1, 0, k) * (result.poseBetween (2, 1, k) * direct);
    EXPECT_LT ((back - p).norm(), 0.01) << "another way home";
  }
  EXPECT_EQ (result.poseBetween (1, 1, 0).parameters, RigidPose{}.parameters);
  EXPECT_THROW (result.poseBetween (0, 3, 0), InvalidInput);
  EXPECT_THROW (result.poseBetween (0, 1, segments.size()), InvalidInput);
}

TEST (MultiframeEstimator, SameBitsForAnyNumberOfThreads)
{
  const Room room (3);
  const Oversegmentation segments = room.segments (0);
  SolverParameters one, three;
  one.threads = 1;
  three.threads = 3;
  const auto a = MultiframeEstimator ({}, one).estimate (room.frames, 0, segments);
  const auto b = MultiframeEstimator ({}, three).estimate (room.frames, 0, segments);
  for (const int k : {1, 2}) {
    EXPECT_TRUE (sameBits (a.frames[k].flow, b.frames[k].flow));
    EXPECT_TRUE (sameBits (a.frames[k].visibility, b.frames[k].visibility));
  }
}

TEST (MultiframeEstimator, StaticBackgroundIsOneBodyAndLetsTheBoxGo)
{
  for (const int frames : {2, 3}) {
    const Room room (frames);
    MultiframeParameters parameters;
    const Oversegmentation segments = room.segments (0);
    const int last = frames - 1;
    const MultiframeSceneFlow plain =
        MultiframeEstimator ({}, {}, parameters).estimate (room.frames, 0, segments);
    parameters.static_background = true;
    const MultiframeSceneFlow known =
        MultiframeEstimator ({}, {}, parameters).estimate (room.frames, 0, segments);
    EXPECT_LE (known.frames[last].groups, plain.frames[last].groups);
    EXPECT_GE (known.frames[last].groups, 2) << "the box moves";
    EXPECT_LT (meanError (room, 0, last, known.frames[last]), 0.12);
    const Eigen::Vector3d wall (0, 0, 2.5);
    const Eigen::Vector3d truth = test::motionBetween (room.scene, 0, 0, last) * wall;
    EXPECT_LT ((known.frames[last].dominant_motion * wall - truth).norm(), 0.005);
  }
}

TEST (MultiframeEstimator, RefusesAFrameWithoutColorAmongColoredOnes)
{
  const Room room (3);
  std::vector<RgbdFrame> frames = room.frames;
  frames[1] = RgbdFrame::fromImages (cv::Mat(), room.views[1].depth, room.scene.camera);
  EXPECT_THROW (MultiframeEstimator().estimate (frames, 0, room.segments (0)),
                InvalidInput);
}

TEST (MultiframeEstimator, LeavesOutDistantPairsWhenAsked)
{
  const Room room (4);
  MultiframeParameters near;
  near.max_span = 1;
  const auto result =
      MultiframeEstimator ({}, {}, near).estimate (room.frames, 0, room.segments (0));
  EXPECT_EQ (result.motions.size(), 5U) << "0-1, 0-2, 0-3, 1-2, 2-3";
  EXPECT_LT (meanError (room, 0, 3, result.frames[3]), 0.2);
  const Eigen::Vector3d p = result.frames[1].segments[0].centroid;
  EXPECT_LT ((result.poseBetween (1, 3, 0) * (result.poseBetween (0, 1, 0) * p) -
              result.poseBetween (0, 3, 0) * p)
                 .norm(),
             1e-9)
      << "by way of the reference";
}

TEST (MultiframeEstimator, OneRigidSegmentGivesTheCamerasMotion)
{
  Room room (3);
  room.scene.motions[1] = room.scene.motions[0]; // the box stands in the room
  room.views = test::renderWindow (room.scene, 3);
  for (int k = 0; k < 3; ++k)
    room.frames[k] = room.scene.frame (room.views[k]);
  SegmentationParameters single;
  single.method = SegmentationMethod::Single;
  const auto result = MultiframeEstimator().estimate (
      room.frames, 0, Oversegmentation::fromFrame (room.frames[0], single));
  const RigidPose truth = test::motionBetween (room.scene, 0, 0, 2);
  EXPECT_THAT (result.frames[2].dominant_motion, test::isNear (truth, 0.001, 0.002));
}

TEST (MultiframeEstimator, CancelsAndReportsIt)
{
  const Room room (3);
  SolverParameters solver;
  int calls = 0;
  double last = 0.0;
  solver.progress = [&] (const Progress& progress) {
    EXPECT_GE (progress.fraction, 0.0);
    EXPECT_LE (progress.fraction, 1.0);
    last = progress.fraction;
    return ++calls < 3;
  };
  const auto result =
      MultiframeEstimator ({}, solver).estimate (room.frames, 0, room.segments (0));
  EXPECT_EQ (calls, 3) << "not asked again";
  EXPECT_EQ (result.report().stop_reason, StopReason::Cancelled);
  EXPECT_FALSE (result.report().converged);
  EXPECT_FALSE (result.frames[2].flow.empty()) << "the best so far";
}

TEST (MultiframeSceneFlow, WithoutTheReferencesFrameHasAnEmptyReport)
{
  MultiframeSceneFlow none;
  EXPECT_EQ (none.report().stop_reason, StopReason::NotRun);
  none.frames.resize (1);
  none.frames[0].report.stop_reason = StopReason::Converged;
  EXPECT_EQ (none.report().stop_reason, StopReason::Converged);
  none.reference = -1;
  EXPECT_EQ (none.report().stop_reason, StopReason::NotRun);
}

TEST (MultiframeEstimator, RefusesBadInput)
{
  const Room room (3);
  const Oversegmentation segments = room.segments (0);
  const MultiframeEstimator estimator;
  EXPECT_THROW (estimator.estimate ({room.frames[0]}, 0, segments), InvalidInput);
  EXPECT_THROW (estimator.estimate (room.frames, 3, segments), InvalidInput);
  EXPECT_THROW (estimator.estimate (room.frames, -1, segments), InvalidInput);
  std::vector<RgbdFrame> gap = room.frames;
  gap[1] = RgbdFrame{};
  EXPECT_THROW (estimator.estimate (gap, 0, segments), InvalidInput);
  MultiframeParameters bad;
  bad.concatenation_weight = -1.0;
  EXPECT_THROW (MultiframeEstimator ({}, {}, bad).estimate (room.frames, 0, segments),
                InvalidInput);
}

} // namespace
