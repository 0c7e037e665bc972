// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/base/tuning/tuning.h"
#include "core/result/input_resolution.h"
#include "support/slanted_plane.h"

namespace {

using namespace pcl_msf;
using test::SlantedPlane;

/** A frame at some finest level, and a result by hand: each pixel's segment is given,
 * and goes by that segment's motion. */
class Carried : public testing::Test {
protected:
  void
  begin (const cv::Mat& depth, int finest_level, const std::vector<RigidPose>& poses)
  {
    FrameParameters parameters;
    parameters.finest_level = finest_level;
    frame_ = RgbdFrame::fromImages ({}, depth, plane_.camera, parameters);
    for (const RigidPose& pose : poses) {
      SegmentMotion motion;
      motion.current_from_reference = pose;
      motion.status = MotionStatus::Determined;
      scene_.segments.push_back (motion);
    }
  }

  /** \param segment of (x, y, depth) */
  template <typename F>
  void
  carry (const F& segment, int threads = 1)
  {
    const FrameLevel& level = frame_.levels()[0];
    const cv::Size size = level.inverse_depth.size();
    scene_.labels = cv::Mat (size, CV_32SC1, cv::Scalar (-1));
    scene_.visibility =
        cv::Mat (size, CV_8UC1, cv::Scalar (pixelValue (Visibility::Visible)));
    scene_.points = cv::Mat (size, CV_32FC3, cv::Scalar::all (std::nan ("")));
    scene_.displacement = scene_.points.clone();
    scene_.flow_deviation = cv::Mat (size, CV_32FC1, cv::Scalar (0.25));
    scene_.displacement_deviation = cv::Mat (size, CV_32FC1, cv::Scalar (0.01));
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const float w = level.inverse_depth.at<float> (y, x);
        if (w <= 0.0f)
          continue;
        const int k = segment (x, y, 1.0f / w);
        const Eigen::Vector3d p = level.camera.backProject (x, y, 1.0 / w);
        const Eigen::Vector3d d = scene_.segments[k].current_from_reference * p - p;
        scene_.labels.at<int> (y, x) = k;
        scene_.points.at<cv::Vec3f> (y, x) = toVec (p);
        scene_.displacement.at<cv::Vec3f> (y, x) = toVec (d);
      }
    carryToInput (frame_, plane_.camera, currentTuning().frame, threads, scene_);
  }

  static cv::Vec3f
  toVec (const Eigen::Vector3d& v)
  {
    return {static_cast<float> (v.x()),
            static_cast<float> (v.y()),
            static_cast<float> (v.z())};
  }

  void
  expectMoved (int x, int y, float depth, const RigidPose& pose) const
  {
    const Eigen::Vector3d p = plane_.camera.backProject (x, y, depth);
    const cv::Vec3f point = scene_.points.at<cv::Vec3f> (y, x);
    EXPECT_LT (cv::norm (point - toVec (p)), 1e-5);
    const cv::Vec3f way = scene_.displacement.at<cv::Vec3f> (y, x);
    EXPECT_LT (cv::norm (way - toVec (pose * p - p)), 1e-5) << x << " " << y;
    const Eigen::Vector2d uv = plane_.camera.project (pose * p);
    const cv::Vec2f flow = scene_.flow.at<cv::Vec2f> (y, x);
    EXPECT_NEAR (flow[0], uv.x() - x, 2e-3);
    EXPECT_NEAR (flow[1], uv.y() - y, 2e-3);
  }

  static RigidPose
  pose (double turn, double shift)
  {
    RigidPose result;
    result.parameters = {turn, -0.5 * turn, 2.0 * turn, shift, 0.5 * shift, -shift};
    return result;
  }

  SlantedPlane plane_;
  RgbdFrame frame_;
  SceneFlow scene_;
};

TEST_F (Carried, RigidMotionIsExactAtEveryPixel)
{
  const cv::Mat depth = plane_.depth();
  for (const int level : {1, 2}) {
    scene_ = {};
    begin (depth, level, {pose (0.05, 0.04)});
    carry ([] (int, int, float) { return 0; });
    ASSERT_EQ (scene_.flow.size(), depth.size());
    EXPECT_EQ (scene_.camera.fx, plane_.camera.fx);
    for (int y = 0; y < depth.rows; ++y)
      for (int x = 0; x < depth.cols; ++x)
        expectMoved (x, y, depth.at<float> (y, x), pose (0.05, 0.04));
    EXPECT_EQ (scene_.segments[0].points, depth.cols * depth.rows);
    EXPECT_EQ (scene_.segments[0].visible_points, depth.cols * depth.rows);
  }
}

TEST_F (Carried, EachSideOfADepthStepMovesWithItsOwn)
{
  const cv::Mat depth = SlantedPlane::step (1.0, 2.0, 41); // an odd column
  begin (depth, 1, {pose (0.0, 0.1), {}});
  carry ([] (int, int, float z) { return z < 1.5f ? 0 : 1; });
  for (int y = 0; y < depth.rows; ++y)
    for (int x = 0; x < depth.cols; ++x) {
      const bool near = x < 41;
      EXPECT_EQ (scene_.labels.at<int> (y, x), near ? 0 : 1) << x;
      expectMoved (x, y, depth.at<float> (y, x), near ? pose (0.0, 0.1) : RigidPose{});
    }
}

TEST_F (Carried, DeviationsInPixelsGrowWithTheImage)
{
  begin (plane_.depth(), 2, {RigidPose{}});
  carry ([] (int, int, float) { return 0; });
  EXPECT_FLOAT_EQ (scene_.flow_deviation.at<float> (33, 21), 1.0f);
  EXPECT_FLOAT_EQ (scene_.displacement_deviation.at<float> (33, 21), 0.01f);
}

TEST_F (Carried, WhatIsUnknownStaysUnknown)
{
  cv::Mat depth = plane_.depth();
  depth (cv::Rect (20, 20, 13, 11)) = std::nan ("");
  begin (depth, 1, {pose (0.02, 0.01)});
  carry ([] (int, int, float) { return 0; });
  for (int y = 20; y < 31; ++y)
    for (int x = 20; x < 33; ++x) {
      EXPECT_EQ (scene_.labels.at<int> (y, x), -1);
      EXPECT_TRUE (scene_.visibility.at<unsigned char> (y, x) == Visibility::NoDepth);
      EXPECT_TRUE (std::isnan (scene_.flow.at<cv::Vec2f> (y, x)[0]));
      EXPECT_TRUE (std::isnan (scene_.displacement.at<cv::Vec3f> (y, x)[0]));
    }
  EXPECT_EQ (scene_.labels.at<int> (19, 33), 0);
}

TEST_F (Carried, PointsOfASegmentWithoutMotionHaveNone)
{
  RigidPose unknown;
  unknown.parameters[3] = std::nan ("");
  begin (SlantedPlane::step (1.0, 2.0, 40), 1, {unknown, {}});
  carry ([] (int, int, float z) { return z < 1.5f ? 0 : 1; });
  EXPECT_EQ (scene_.labels.at<int> (30, 11), 0);
  EXPECT_TRUE (std::isnan (scene_.flow.at<cv::Vec2f> (30, 11)[0]));
  EXPECT_LT (cv::norm (scene_.flow.at<cv::Vec2f> (30, 71)), 1e-5);
}

TEST_F (Carried, ManyThreadsGiveTheSameBits)
{
  const cv::Mat depth = SlantedPlane::step (1.0, 2.0, 41);
  const auto sides = [] (int, int, float z) { return z < 1.5f ? 0 : 1; };
  begin (depth, 1, {pose (0.03, 0.1), pose (-0.02, 0.05)});
  SceneFlow start = scene_;
  carry (sides);
  std::swap (start, scene_);
  carry (sides, 3);
  const cv::Mat one = start.displacement.reshape (1);
  const cv::Mat three = scene_.displacement.reshape (1);
  EXPECT_EQ (cv::countNonZero (one != three), 0);
}

} // namespace
