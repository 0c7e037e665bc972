// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/standing_room.h"
#include <gmock/gmock.h>
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/piecewise_rigid_registration.h>
#include <pcl_msf/piecewise_rigid_tracker.h>

#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace {

using namespace pcl_msf;
using test::distanceToTruth;
using test::standingRoom;

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

TEST (PiecewiseRigidTracker, OneThatWasMovedFromIsEmptyAndBeginsAnew)
{
  const test::AnalyticScene scene = standingRoom();
  const auto views = test::renderWindow (scene, 2);
  PiecewiseRigidTracker<pcl::PointXYZI> tracker;
  for (const test::View& view : views)
    ASSERT_TRUE (tracker.addCloud (toCloud (scene, view)));
  const Cloud wanted = tracker.getWarpedCloud();
  PiecewiseRigidTracker<pcl::PointXYZI> moved (std::move (tracker));
  EXPECT_EQ (moved.getWarpedCloud() (80, 60).x, wanted (80, 60).x);
  PiecewiseRigidTracker<pcl::PointXYZI>& empty = tracker;
  EXPECT_TRUE (empty.getWarpedCloud().empty());
  EXPECT_TRUE (empty.getReferenceCloud() == nullptr);
  EXPECT_TRUE (empty.getSceneFlow().displacement.empty());
  EXPECT_EQ (empty.getMultiframeSceneFlow().report().stop_reason, StopReason::NotRun);
  for (const test::View& view : views)
    ASSERT_TRUE (empty.addCloud (toCloud (scene, view)));
  EXPECT_EQ (empty.getWarpedCloud() (80, 60).x, wanted (80, 60).x);
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

template <typename Tracker, typename = void>
constexpr bool kTakesNormals = false;
template <typename Tracker>
constexpr bool kTakesNormals<
    Tracker,
    std::void_t<decltype (std::declval<Tracker&>().setSourceNormals (nullptr))>> = true;

TEST (PiecewiseRigidTracker, HasNoSettingThatItWouldIgnore)
{
  EXPECT_FALSE (kTakesNormals<PiecewiseRigidTracker<pcl::PointXYZI>>);
  EXPECT_TRUE (kTakesNormals<PiecewiseRigidRegistration<pcl::PointXYZI>>);
}

TEST (PiecewiseRigidTracker, NamesItselfWhenItRefuses)
{
  PiecewiseRigidTracker<pcl::PointXYZI> tracker;
  ::testing::internal::CaptureStderr();
  SegmentationParameters segmentation;
  segmentation.segment_size = 0;
  tracker.setSegmentationParameters (segmentation);
  SolverParameters solver;
  solver.max_seconds = -1.0;
  tracker.setSolverParameters (solver);
  EXPECT_EQ (tracker.getSolverParameters().max_seconds, 0.0) << "as it was";
  const std::string printed = ::testing::internal::GetCapturedStderr();
  for (const char* method : {"setSegmentationParameters", "setSolverParameters"})
    EXPECT_THAT (
        printed,
        ::testing::HasSubstr (std::string ("[pcl_msf::PiecewiseRigidTracker::") +
                              method + "] "));
}

TEST (PiecewiseRigidTracker, CarriesEveryPointAtACoarserFinestLevel)
{
  const test::AnalyticScene scene = standingRoom();
  PiecewiseRigidTracker<pcl::PointXYZI> tracker;
  FrameParameters half;
  half.finest_level = 1;
  tracker.setFrameParameters (half);
  int frame = 0;
  for (const test::View& view : test::renderWindow (scene, 3)) {
    ASSERT_TRUE (tracker.addCloud (toCloud (scene, view)));
    const RigidPose camera = RigidPose::fromMatrix (tracker.getCameraPose());
    EXPECT_LT (distanceToTruth (scene, frame, camera), 0.006 * (1 + frame));
    ++frame;
  }
  const Cloud warped = tracker.getWarpedCloud();
  EXPECT_EQ (warped.width, static_cast<unsigned> (scene.width));
  EXPECT_EQ (warped.height, static_cast<unsigned> (scene.height));
  EXPECT_TRUE (std::isfinite (warped (81, 61).x));
}

} // namespace
