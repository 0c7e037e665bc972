// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/window_scene.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/piecewise_rigid_tracker.h>

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
  EXPECT_EQ (tracker.firstFrame(), kFrames - 3);
  EXPECT_EQ (tracker.result().frames.size(), 3U);
  EXPECT_FALSE (tracker.sceneFlow().flow.empty());
}

TEST (SceneFlowTracker, MergedSegmentsNeverGrowInNumberOnOneSurface)
{
  const test::AnalyticScene scene = standingRoom();
  TrackerParameters parameters;
  parameters.window = 3;
  parameters.merge_segments = true;
  SceneFlowTracker tracker = makeTracker (parameters);
  int first = 0;
  for (const test::View& view : test::renderWindow (scene, kFrames)) {
    tracker.add (scene.frame (view));
    first = first == 0 ? tracker.segments().size() : first;
  }
  EXPECT_LT (tracker.segments().size(), first);
}

TEST (SceneFlowTracker, BeginsAnewWhenTheReferenceShowsNothingOfTheFrame)
{
  const test::AnalyticScene scene = test::roomWithBox();
  TrackerParameters parameters;
  parameters.window = 4;
  parameters.least_visible = 1.0; // never satisfied
  SceneFlowTracker tracker = makeTracker (parameters);
  for (const test::View& view : test::renderWindow (scene, 4))
    tracker.add (scene.frame (view));
  EXPECT_EQ (tracker.frames(), 2);
  EXPECT_EQ (tracker.firstFrame(), 2);
}

TEST (SceneFlowTracker, WindowOfTwoIsFrameToFrame)
{
  const test::AnalyticScene scene = test::roomWithBox();
  TrackerParameters parameters;
  parameters.window = 2;
  SceneFlowTracker tracker = makeTracker (parameters);
  for (const test::View& view : test::renderWindow (scene, 3))
    tracker.add (scene.frame (view));
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
  }
  EXPECT_EQ (tracker.getReferenceIndex(), 1);
  EXPECT_EQ (tracker.getReferenceCloud(), clouds[1]);
  const Cloud warped = tracker.getWarpedCloud();
  ASSERT_TRUE (warped.isOrganized());
  const Eigen::Vector3d truth = test::motionBetween (scene, 0, 1, 3) *
                                (*clouds[1]) (80, 60).getVector3fMap().cast<double>();
  EXPECT_LT ((warped (80, 60).getVector3fMap().cast<double>() - truth).norm(), 0.01);
  const RigidPose camera = RigidPose::fromMatrix (tracker.getCameraPose());
  EXPECT_LT (distanceToTruth (scene, 3, camera), 0.015);
  tracker.restart();
  EXPECT_TRUE (tracker.getReferenceCloud() == nullptr);
}

} // namespace
