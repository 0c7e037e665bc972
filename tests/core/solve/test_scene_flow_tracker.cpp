// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/window_scene.h"
#include <gmock/gmock.h>
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/piecewise_rigid_tracker.h>
#include <pcl_msf/scene_flow_estimator.h>

#include <cmath>
#include <cstring>
#include <map>

namespace {

using namespace pcl_msf;

constexpr int kFrames = 6;

/** The room with the box standing in it, seen by a moving camera; small motion. */
test::AnalyticScene
standingRoom ()
{
  test::AnalyticScene scene = test::roomWithBox();
  scene.motions[1] = scene.motions[0];
  return scene;
}

SceneFlowTracker
makeTracker (const TrackerParameters& parameters)
{
  return SceneFlowTracker (parameters, {}, {}, {}, {});
}

double
distanceToTruth (const test::AnalyticScene& scene, int frame, const RigidPose& found)
{
  const RigidPose truth = test::motionBetween (scene, 0, 0, frame).inverse();
  return (found * Eigen::Vector3d (0, 0, 2.5) - truth * Eigen::Vector3d (0, 0, 2.5))
      .norm();
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
  for (const unsigned threads : {1U, 2U}) {
    SolverParameters solver;
    solver.threads = threads;
    TrackerParameters parameters;
    parameters.window = 3;
    SceneFlowTracker tracker (parameters, {}, {}, solver, {});
    for (const test::View& view : test::renderWindow (scene, 4))
      tracker.add (scene.frame (view));
    flows.push_back (tracker.sceneFlow().flow);
  }
  int different = 0;
  for (int y = 0; y < flows[0].rows; ++y)
    for (int x = 0; x < flows[0].cols; ++x)
      different += std::memcmp (&flows[0].at<cv::Vec2f> (y, x),
                                &flows[1].at<cv::Vec2f> (y, x),
                                sizeof (cv::Vec2f)) != 0;
  EXPECT_EQ (different, 0);
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

using Cloud = pcl::PointCloud<pcl::PointXYZI>;

Cloud::Ptr
toCloud (const test::AnalyticScene& scene, const test::View& view)
{
  auto cloud = pcl::make_shared<Cloud> (scene.width, scene.height);
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const Eigen::Vector3d p =
          scene.camera.backProject (x, y, view.depth.at<float> (y, x));
      (*cloud) (x, y).getVector3fMap() = p.cast<float>();
      (*cloud) (x, y).intensity = view.color.at<float> (y, x);
    }
  cloud->is_dense = false;
  return cloud;
}

TEST (PiecewiseRigidTracker, TakesCloudsAndGivesTheReferenceCarried)
{
  const test::AnalyticScene scene = standingRoom();
  PiecewiseRigidTracker<pcl::PointXYZI> tracker;
  TrackerParameters parameters;
  parameters.window = 3;
  tracker.setTrackerParameters (parameters);
  EXPECT_FALSE (tracker.addCloud (nullptr));
  EXPECT_TRUE (tracker.getReferenceCloud() == nullptr);
  std::vector<Cloud::Ptr> clouds;
  for (const test::View& view : test::renderWindow (scene, 4)) {
    clouds.push_back (toCloud (scene, view));
    ASSERT_TRUE (tracker.addCloud (clouds.back()));
    test::View blind = view;
    blind.depth = std::nanf ("");
    EXPECT_FALSE (tracker.addCloud (toCloud (scene, blind))) << "and goes on";
  }
  EXPECT_EQ (tracker.getReferenceIndex(), 0);
  EXPECT_EQ ((*tracker.getReferenceCloud()) (80, 60).x, (*clouds[0]) (80, 60).x);
  EXPECT_EQ (clouds[0].use_count(), 1) << "given back";
  const Cloud warped = tracker.getWarpedCloud();
  ASSERT_TRUE (warped.isOrganized());
  const Eigen::Vector3d truth = test::motionBetween (scene, 0, 0, 3) *
                                (*clouds[0]) (80, 60).getVector3fMap().cast<double>();
  EXPECT_LT ((warped (80, 60).getVector3fMap().cast<double>() - truth).norm(), 0.01);
  const RigidPose camera = RigidPose::fromMatrix (tracker.getCameraPose());
  EXPECT_LT (distanceToTruth (scene, 3, camera), 0.015);
  tracker.restart();
  EXPECT_TRUE (tracker.getReferenceCloud() == nullptr);
}

TEST (PiecewiseRigidTracker, RefusesACloudOfAnotherFrameAndGoesOn)
{
  const test::AnalyticScene scene = standingRoom();
  const auto views = test::renderWindow (scene, 2);
  for (const bool given : {false, true}) {
    PiecewiseRigidTracker<pcl::PointXYZI> tracker;
    if (given)
      tracker.setCamera (scene.camera);
    ASSERT_TRUE (tracker.addCloud (toCloud (scene, views[0])));
    const Cloud::Ptr moved = toCloud (scene, views[1]);
    for (auto& point : *moved)
      point.x += 1.0f;
    testing::internal::CaptureStderr();
    EXPECT_FALSE (tracker.addCloud (moved));
    EXPECT_THAT (testing::internal::GetCapturedStderr(),
                 testing::HasSubstr ("the camera is at (1, "));
    EXPECT_TRUE (tracker.addCloud (toCloud (scene, views[1])));
  }
}

TEST (PiecewiseRigidTracker, KeepsTheUnitOfItsFirstIntensities)
{
  const test::AnalyticScene scene = standingRoom();
  const test::View view = scene.render (false);
  double unit = 0.0;
  const auto brightness = [&] (float factor) {
    const Cloud::Ptr cloud = toCloud (scene, view);
    for (auto& point : *cloud)
      point.intensity *= factor;
    return cv::mean (
        detail::makeFrames ({{coordinateImage (*cloud), colorImage (*cloud)}},
                            0,
                            scene.camera,
                            {},
                            cv::Mat(),
                            &unit)
            .front()
            .levels()[0]
            .intensity)[0];
  };
  const double first = brightness (1000.0f);
  EXPECT_EQ (unit, 1023.0);
  EXPECT_NEAR (brightness (200.0f), 0.2 * first, 1e-4);
  EXPECT_EQ (unit, 1023.0);
  EXPECT_LT (brightness (3000.0f), 1.5 * first); // a larger unit, as it must
}

TEST (PiecewiseRigidTracker, WarpsTheReferenceOfTheNewWindow)
{
  const test::AnalyticScene scene = standingRoom();
  PiecewiseRigidTracker<pcl::PointXYZI> tracker;
  TrackerParameters parameters;
  parameters.window = 2;
  tracker.setTrackerParameters (parameters);
  std::vector<Cloud::Ptr> clouds;
  for (const test::View& view : test::renderWindow (scene, 3)) {
    clouds.push_back (toCloud (scene, view));
    ASSERT_TRUE (tracker.addCloud (clouds.back()));
    EXPECT_FALSE (tracker.addCloud (pcl::make_shared<Cloud>())) << "no cloud";
  }
  EXPECT_EQ (tracker.getReferenceIndex(), 1);
  EXPECT_EQ ((*tracker.getReferenceCloud()) (80, 60).x, (*clouds[1]) (80, 60).x);
  const Eigen::Vector3d truth = test::motionBetween (scene, 0, 1, 2) *
                                (*clouds[1]) (80, 60).getVector3fMap().cast<double>();
  const Cloud warped = tracker.getWarpedCloud();
  EXPECT_LT ((warped (80, 60).getVector3fMap().cast<double>() - truth).norm(), 0.01);
}

TEST (PiecewiseRigidTracker, OneObjectCanBeFilledAnewForEachCloud)
{
  const test::AnalyticScene scene = standingRoom();
  PiecewiseRigidTracker<pcl::PointXYZI> refilled, apart;
  const auto object = pcl::make_shared<Cloud>();
  for (const test::View& view : test::renderWindow (scene, 3)) {
    const auto cloud = toCloud (scene, view);
    ASSERT_TRUE (apart.addCloud (cloud));
    *object = *cloud;
    ASSERT_TRUE (refilled.addCloud (object));
  }
  object->clear();
  const Cloud wanted = apart.getWarpedCloud();
  const Cloud warped = refilled.getWarpedCloud();
  ASSERT_EQ (warped.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i)
    ASSERT_EQ (std::memcmp (&warped[i], &wanted[i], 3 * sizeof (float)), 0) << i;
}

TEST (PiecewiseRigidTracker, NormalsTurnAndTheSensorPoseStays)
{
  using Point = pcl::PointXYZRGBNormal;
  const test::AnalyticScene scene = standingRoom();
  PiecewiseRigidTracker<Point> tracker;
  for (const test::View& view : test::renderWindow (scene, 2)) {
    const auto plain = toCloud (scene, view);
    const auto cloud = pcl::make_shared<pcl::PointCloud<Point>> (
        plain->width, plain->height, Point (0.0f, 0.0f, 0.0f, 0, 0, 0, 0.6f, 0, -0.8f));
    for (std::size_t i = 0; i < cloud->size(); ++i)
      (*cloud)[i].getVector3fMap() = (*plain)[i].getVector3fMap();
    cloud->is_dense = false;
    cloud->sensor_origin_ = {1.0f, 2.0f, 3.0f, 0.0f};
    ASSERT_TRUE (tracker.addCloud (cloud));
  }
  const pcl::PointCloud<Point> warped = tracker.getWarpedCloud();
  EXPECT_EQ (warped.sensor_origin_, Eigen::Vector4f (1.0f, 2.0f, 3.0f, 0.0f));
  const SceneFlow& flow = tracker.getSceneFlow();
  const int label = flow.labels.at<int> (60, 80);
  ASSERT_GE (label, 0);
  const Eigen::Matrix3f turn =
      flow.segments[label].current_from_reference.rotation().cast<float>();
  const Eigen::Vector3f turned = turn * Eigen::Vector3f (0.6f, 0.0f, -0.8f);
  EXPECT_GT ((turned - Eigen::Vector3f (0.6f, 0.0f, -0.8f)).norm(), 1e-4f);
  EXPECT_LT ((warped (80, 60).getNormalVector3fMap() - turned).norm(), 1e-6f);
}

} // namespace
