// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/points.h"
#include "support/pose_matcher.h"
#include "support/room.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>

#include <cmath>

namespace {

using namespace pcl_msf;
using Room = test::Room;

TEST_F (Room, FlowIsRightWhereBothFramesSee)
{
  const SceneFlow result = estimate();
  const auto all = errors (result);
  const auto box = errors (result, 1);
  // Images without noise: what remains is bilinear sampling, a few hundredths of a
  // pixel. Along the box's outline a pixel's segment may be the wrong one; that strip
  // is about 3 % of the image, at 6 px apart.
  EXPECT_LT (all[all.size() / 2], 0.05);
  EXPECT_LT (mean (all), 0.25);
  EXPECT_LT (box[box.size() / 2], 0.1);
  EXPECT_LT (mean (box), 0.4);
}

TEST_F (Room, FlowIsRightUnderAnotherLight)
{
  reference_ = scene_.frame (test::faded (view_));
  current_ = scene_.frame (test::underOtherLight (test::faded (scene_.render (true))));
  const SceneFlow result = estimate();
  EXPECT_TRUE (result.report.light_changed);
  const auto all = errors (result);
  EXPECT_LT (all[all.size() / 2], 0.03);
  EXPECT_LT (mean (all), 0.04);
}

TEST_F (Room, DisplacementsAreMetresAndFlowIsTheirPicture)
{
  SolverParameters solver = alone();
  solver.blend_motions = false; // each point moves with its segment alone
  solver.refine_flow = false;
  const SceneFlow result = estimate (solver);
  for (int y = 0; y < scene_.height; y += 5)
    for (int x = 0; x < scene_.width; x += 5) {
      const cv::Vec3f p = result.points.at<cv::Vec3f> (y, x);
      const cv::Vec3f d = result.displacement.at<cv::Vec3f> (y, x);
      if (std::isnan (d[0]))
        continue;
      EXPECT_NEAR (p[2], view_.depth.at<float> (y, x), 1e-5);
      const Eigen::Vector2d uv =
          scene_.camera.project ({p[0] + d[0], p[1] + d[1], p[2] + d[2]});
      EXPECT_NEAR (uv.x() - x, result.flow.at<cv::Vec2f> (y, x)[0], 1e-3);
      EXPECT_NEAR (uv.y() - y, result.flow.at<cv::Vec2f> (y, x)[1], 1e-3);
      const Eigen::Vector3d q =
          result.warp ({p[0], p[1], p[2]}, result.labels.at<int> (y, x));
      EXPECT_NEAR (q.x(), p[0] + d[0], 1e-5);
    }
}

TEST_F (Room, BodiesAreTheRoomAndTheBox)
{
  const SceneFlow result = estimate();
  EXPECT_GE (result.groups, 2);
  EXPECT_LE (result.groups, 8);
  ASSERT_EQ (result.dominant_group, 0);
  // Where most room points and most box points belong.
  int room_dominant = 0, room = 0, box_dominant = 0, box = 0;
  for (int y = 0; y < scene_.height; ++y)
    for (int x = 0; x < scene_.width; ++x) {
      const int label = result.labels.at<int> (y, x);
      if (label < 0)
        continue;
      const bool dominant = result.segments[label].group == result.dominant_group;
      const bool on_box = view_.body.at<int> (y, x) == 1;
      (on_box ? box : room) += 1;
      (on_box ? box_dominant : room_dominant) += dominant ? 1 : 0;
    }
  EXPECT_GT (room_dominant, 0.95 * room);
  EXPECT_LT (box_dominant, 0.1 * box);
}

TEST_F (Room, DominantMotionIsTheCamerasOwn)
{
  const RigidPose found = estimate().dominant_motion;
  const RigidPose error = found * scene_.motions[0].inverse();
  // 0.15 pixels, what the noise model grants rigid segments anyway.
  EXPECT_LT (error.angle(), 0.15 / scene_.camera.fx);
  const Eigen::Vector3d p (0.0, 0.0, 2.5);
  EXPECT_LT ((found * p - scene_.motions[0] * p).norm(), 0.15 * 2.5 / scene_.camera.fx);
}

TEST_F (Room, UnknownIsNaNAndHiddenIsSaid)
{
  const SceneFlow result = estimate();
  const test::Truth truth = scene_.truth (view_);
  int covered = 0, said_covered = 0, seen = 0, said_seen = 0;
  for (int y = 0; y < scene_.height; ++y)
    for (int x = 0; x < scene_.width; ++x) {
      const int visibility = result.visibility.at<unsigned char> (y, x);
      if (kHole.contains ({x, y})) {
        EXPECT_EQ (visibility, Visibility::NoDepth);
        EXPECT_TRUE (std::isnan (result.flow.at<cv::Vec2f> (y, x)[0]));
        EXPECT_TRUE (std::isnan (result.displacement.at<cv::Vec3f> (y, x)[2]));
        EXPECT_EQ (result.labels.at<int> (y, x), -1);
        continue;
      }
      EXPECT_NE (visibility, Visibility::NoDepth);
      const cv::Vec2f end = truth.flow.at<cv::Vec2f> (y, x);
      const bool inside = x + end[0] >= 0 && x + end[0] <= scene_.width - 1 &&
                          y + end[1] >= 0 && y + end[1] <= scene_.height - 1;
      if (truth.visible.at<unsigned char> (y, x)) {
        ++seen;
        said_seen += visibility == Visibility::Visible ? 1 : 0;
      }
      else if (inside) {
        ++covered;
        said_covered += visibility == Visibility::Occluded ? 1 : 0;
      }
      else
        EXPECT_NE (visibility, Visibility::Occluded);
    }
  ASSERT_GT (covered, 50);
  EXPECT_GT (said_covered, 0.7 * covered);
  EXPECT_GT (said_seen, 0.95 * seen);
}

TEST_F (Room, OneSegmentIsARigidScene)
{
  test::AnalyticScene rigid = scene_;
  rigid.motions[1] = rigid.motions[0];
  SegmentationParameters cut;
  cut.method = SegmentationMethod::Single;
  const SceneFlow result =
      SceneFlowEstimator ({}, alone())
          .estimate (reference_,
                     rigid.frame (rigid.render (true)),
                     Oversegmentation::fromFrame (reference_, cut));
  EXPECT_EQ (result.groups, 1);
  EXPECT_EQ (result.segments[0].status, MotionStatus::Determined);
  EXPECT_EQ (result.segments[0].rank, 6);
  EXPECT_THAT (result.dominant_motion, test::isNear (rigid.motions[0], 0.0003, 0.001));
}

TEST_F (Room, EveryVariantOfTheEnergySolvesIt)
{
  std::vector<EnergyParameters> energies (5);
  energies[0].loss = LossType::L1;
  energies[1].loss = LossType::L2;
  energies[2].pose_difference = PoseDifference::Parameters;
  energies[2].regularizer_weight = 200.0; // radians and metres, not pixels
  energies[3].neighbors = 0;
  energies[4].regularizer_weight = 0.0;
  for (std::size_t i = 0; i < energies.size(); ++i)
    for (const LinearSolver linear :
         {LinearSolver::Cgnr, LinearSolver::SparseCholesky}) {
      SolverParameters solver = alone();
      solver.linear_solver = linear;
      const SceneFlow result = SceneFlowEstimator (energies[i], solver)
                                   .estimate (reference_, current_, segments_);
      const auto all = errors (result);
      EXPECT_LT (all[all.size() / 2], 0.15) << i;
    }
}

TEST (GeometryOnly, BumpySurfaceIsEnough)
{
  const PinholeCamera camera{150.0, 150.0, 79.5, 59.5};
  const RigidPose motion =
      test::turnAbout ({0, 0, 2}, {0.01, -0.012, 0.01}, {0.02, -0.015, 0.01});
  // z = f (x, y) of the surface's own frame, met by rays of either view.
  const auto height = [] (const Eigen::Vector3d& p) {
    return 2.0 + 0.08 * std::sin (6.0 * p.x()) * std::cos (5.0 * p.y()) +
           0.05 * std::cos (4.0 * p.x() + 7.0 * p.y());
  };
  const auto depth = [&] (const RigidPose& pose) {
    const RigidPose back = pose.inverse();
    return test::image (160, 120, [&] (int x, int y) {
      double z = 2.0;
      for (int i = 0; i < 100; ++i) {
        const Eigen::Vector3d p = back * camera.backProject (x, y, z);
        z += 0.7 * (height (p) - p.z());
      }
      return z;
    });
  };
  const RgbdFrame reference = RgbdFrame::fromImages ({}, depth ({}), camera);
  const RgbdFrame current = RgbdFrame::fromImages ({}, depth (motion), camera);
  const SceneFlow result = SceneFlowEstimator().estimate (
      reference, current, Oversegmentation::fromFrame (reference));
  const Eigen::Vector3d p (0.0, 0.0, 2.0);
  EXPECT_LT ((result.dominant_motion * p - motion * p).norm(), 0.002);
  EXPECT_LT ((result.dominant_motion * motion.inverse()).angle(), 0.001);
  EXPECT_GT (cv::countNonZero (result.visibility == pixelValue (Visibility::Visible)),
             0.85 * 160 * 120);
}

/** Both frames halved before anything else. */
class HalvedRoom : public Room {
protected:
  HalvedRoom()
  {
    FrameParameters half;
    half.finest_level = 1;
    half.smoothing_sigma = 0.0;
    reference_ = scene_.frame (view_, half);
    current_ = scene_.frame (scene_.render (true), half);
    SegmentationParameters cut;
    cut.segment_size = 10;
    segments_ = Oversegmentation::fromFrame (reference_, cut);
  }
};

TEST_F (HalvedRoom, FlowIsThatOfEveryPixelOfTheInput)
{
  const SceneFlow result = estimate();
  for (const cv::Mat& image : {result.labels,
                               result.points,
                               result.displacement,
                               result.flow,
                               result.visibility,
                               result.flow_deviation,
                               result.displacement_deviation})
    ASSERT_EQ (image.size(), view_.depth.size());
  EXPECT_EQ (result.camera.fx, scene_.camera.fx);
  const auto all = errors (result);
  const auto box = errors (result, 1);
  EXPECT_LT (all[all.size() / 2], 0.1);
  EXPECT_LT (mean (all), 0.4);
  EXPECT_LT (box[box.size() / 2], 0.3);
  EXPECT_TRUE (std::isnan (result.flow.at<cv::Vec2f> (kHole.y, kHole.x)[0]));
  int points = 0;
  for (const SegmentMotion& segment : result.segments)
    points += segment.points;
  EXPECT_EQ (points, cv::countNonZero (result.labels >= 0));
}

TEST_F (HalvedRoom, FramesOfTwoFinestLevelsAreRefused)
{
  FrameParameters quarter;
  quarter.finest_level = 2;
  scene_.width *= 2;
  scene_.height *= 2;
  current_ = scene_.frame (scene_.render (true), quarter);
  try {
    estimate();
    FAIL();
  }
  catch (const InvalidInput& error) {
    EXPECT_THAT (error.what(), testing::HasSubstr ("different finest_level, 1 and 2"));
  }
}

} // namespace
