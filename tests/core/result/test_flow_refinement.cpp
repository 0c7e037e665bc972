// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/result/flow_refinement.h"

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;

constexpr int kWidth = 240;
constexpr int kHeight = 160;
constexpr int kBorder = 140; ///< column at which segment 1 begins
constexpr float kDepth = 2.0f;

/** A texture without repetition, [0, 1]. */
double
texture (double x, double y)
{
  return 0.5 + 0.12 * std::sin (0.81 * x + 0.31 * y) +
         0.12 * std::sin (0.73 * y - 0.25 * x + 1.0) +
         0.1 * std::sin (0.0031 * x * x + 0.33 * y) +
         0.1 * std::sin (0.0043 * y * y + 0.47 * x);
}

/** A wall of two segments before a camera that looks at it straight: the left one at
 * rest, the right one moving along the rows. */
class Wall : public testing::Test {
protected:
  Wall()
  {
    scene_.camera.fx = scene_.camera.fy = 200.0;
    scene_.camera.cx = 0.5 * (kWidth - 1);
    scene_.camera.cy = 0.5 * (kHeight - 1);
    scene_.labels = cv::Mat (kHeight, kWidth, CV_32SC1, cv::Scalar (0));
    scene_.labels.colRange (kBorder, kWidth).setTo (1);
    scene_.segments.resize (2);
    scene_.segments[0].points = kBorder * kHeight;
    scene_.segments[1].points = (kWidth - kBorder) * kHeight;
    scene_.segments[1].current_from_reference.parameters[3] = 1.0;
    for (SegmentMotion& segment : scene_.segments)
      segment.status = MotionStatus::Determined;
    images_.noise = 0.007;
    images_.reference = cv::Mat (kHeight, kWidth, CV_32FC1);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        images_.reference.at<float> (y, x) = static_cast<float> (texture (x, y));
  }

  /** The current image: the right part stretched and moved. \param stretch share
   * \param shift pixels */
  void
  show (double stretch, double shift)
  {
    stretch_ = stretch;
    shift_ = shift;
    images_.current = images_.reference.clone();
    for (int y = 0; y < kHeight; ++y)
      for (int x = kBorder; x < kWidth; ++x)
        images_.current.at<float> (y, x) = static_cast<float> (
            texture (kBorder + (x - kBorder - shift) / (1.0 + stretch), y));
  }

  double
  trueFlow (int x) const
  {
    return x < kBorder ? 0.0 : shift_ + stretch_ * (x - kBorder);
  }

  /** Optical flow with an error. */
  void
  nearTruth (double error)
  {
    images_.flow = cv::Mat (kHeight, kWidth, CV_32FC2);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        images_.flow.at<cv::Vec2f> (y, x) = {static_cast<float> (trueFlow (x) + error),
                                             static_cast<float> (error)};
  }

  /** The flow that the segments' motions give. \param right pixels along the rows */
  void
  move (float right)
  {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto fx = static_cast<float> (scene_.camera.fx);
    scene_.points = cv::Mat (kHeight, kWidth, CV_32FC3, cv::Scalar::all (nan));
    scene_.flow = cv::Mat (kHeight, kWidth, CV_32FC2, cv::Scalar (0, 0));
    scene_.displacement = cv::Mat (kHeight, kWidth, CV_32FC3, cv::Scalar (0, 0, 0));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const float u = x < kBorder ? 0.0f : right;
        scene_.points.at<cv::Vec3f> (y, x) = {
            static_cast<float> (x - scene_.camera.cx) / fx * kDepth,
            static_cast<float> (y - scene_.camera.cy) / fx * kDepth,
            kDepth};
        scene_.flow.at<cv::Vec2f> (y, x) = {u, 0.0f};
        scene_.displacement.at<cv::Vec3f> (y, x) = {u / fx * kDepth, 0.0f, 0.0f};
      }
  }

  void
  refine (int threads = 1)
  {
    const cv::Mat mask = pointsToRefine (scene_, tuning_, threads);
    ASSERT_FALSE (mask.empty());
    refineFlow (images_, scene_.camera, mask, tuning_, threads, scene_);
  }

  /** Mean error of the right part, pixels, without its borders. */
  double
  error () const
  {
    double sum = 0.0;
    int count = 0;
    for (int y = 10; y < kHeight - 10; ++y)
      for (int x = kBorder + 10; x < kWidth - 20; ++x, ++count) {
        const cv::Vec2f f = scene_.flow.at<cv::Vec2f> (y, x);
        sum += std::hypot (f[0] - trueFlow (x), f[1]);
      }
    return sum / count;
  }

  SceneFlow scene_;
  ComparedImages images_;
  RefinementTuning tuning_;

private:
  double stretch_{0.0};
  double shift_{0.0};
};

TEST_F (Wall, SoftSurfaceFollowsTheImages)
{
  show (0.03, 0.0);
  move (1.5f);
  const double before = error();
  tuning_.iterations = 30;
  refine();
  EXPECT_GT (before, 0.5);
  EXPECT_LT (error(), 0.6 * before);
}

TEST_F (Wall, SoftSurfaceFollowsOpticalFlow)
{
  show (0.03, 0.0);
  move (1.5f);
  const double before = error();
  nearTruth (0.1);
  refine();
  EXPECT_LT (error(), 0.4 * before);
}

TEST_F (Wall, PointsMoveAcrossTheLineOfSight)
{
  show (0.03, 0.0);
  nearTruth (0.1);
  move (1.5f);
  refine();
  for (int x = 0; x < kWidth; x += 7) {
    const cv::Vec3f q =
        scene_.points.at<cv::Vec3f> (80, x) + scene_.displacement.at<cv::Vec3f> (80, x);
    const Eigen::Vector2d uv = scene_.camera.project ({q[0], q[1], q[2]});
    EXPECT_EQ (q[2], kDepth);
    EXPECT_NEAR (uv.x() - x, scene_.flow.at<cv::Vec2f> (80, x)[0], 1e-4);
    EXPECT_NEAR (uv.y() - 80, scene_.flow.at<cv::Vec2f> (80, x)[1], 1e-4);
  }
}

TEST_F (Wall, CommonBodyKeepsItsMotion)
{
  show (0.03, 0.0);
  nearTruth (0.1);
  move (1.5f);
  const cv::Mat flow = scene_.flow.clone();
  refine();
  EXPECT_EQ (cv::norm (flow.colRange (0, kBorder),
                       scene_.flow.colRange (0, kBorder),
                       cv::NORM_INF),
             0.0);
  EXPECT_GT (cv::norm (flow, scene_.flow, cv::NORM_INF), 0.5);
}

TEST_F (Wall, MotionThatExplainsTheImagesStaysToTheBit)
{
  show (0.0, 2.0);
  move (2.0f);
  const cv::Mat flow = scene_.flow.clone();
  const cv::Mat displacement = scene_.displacement.clone();
  refine();
  EXPECT_EQ (cv::norm (flow, scene_.flow, cv::NORM_INF), 0.0);
  EXPECT_EQ (cv::norm (displacement, scene_.displacement, cv::NORM_INF), 0.0);
}

TEST_F (Wall, OpticalFlowTakesTheWrongMotionsPlace)
{
  show (0.0, 12.0);
  move (0.0f);
  refine();
  const double alone = error();
  move (0.0f);
  images_.flow = cv::Mat (kHeight, kWidth, CV_32FC2, cv::Scalar (0, 0));
  images_.flow.colRange (kBorder, kWidth).setTo (cv::Scalar (12, 0));
  refine();
  EXPECT_GT (alone, 4.0);
  EXPECT_LT (error(), 0.5);
}

TEST_F (Wall, WrongOpticalFlowIsNotTaken)
{
  show (0.0, 2.0);
  move (2.0f);
  images_.flow = cv::Mat (kHeight, kWidth, CV_32FC2, cv::Scalar (-7, 4));
  refine();
  EXPECT_LT (error(), 0.01);
}

TEST_F (Wall, UnknownAndLeavingPointsStay)
{
  show (0.03, 0.0);
  nearTruth (0.1);
  move (1.5f);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scene_.flow (cv::Rect (180, 60, 20, 20)).setTo (cv::Scalar::all (nan));
  scene_.flow.at<cv::Vec2f> (50, kWidth - 3) = {30.0f, 0.0f};
  refine();
  EXPECT_TRUE (std::isnan (scene_.flow.at<cv::Vec2f> (70, 190)[0]));
  EXPECT_EQ (scene_.flow.at<cv::Vec2f> (50, kWidth - 3)[0], 30.0f);
  EXPECT_NE (scene_.flow.at<cv::Vec2f> (70, 176)[0], 1.5f);
}

TEST_F (Wall, SameForAnyNumberOfThreads)
{
  show (0.03, 1.0);
  nearTruth (0.1);
  tuning_.tile = 32;
  move (1.5f);
  refine (1);
  const cv::Mat one = scene_.flow.clone();
  move (1.5f);
  refine (7);
  EXPECT_EQ (cv::norm (one, scene_.flow, cv::NORM_INF), 0.0);
}

TEST_F (Wall, TilesShowNoSeams)
{
  show (0.03, 1.0);
  nearTruth (0.1);
  move (1.5f);
  tuning_.tile = 1000;
  refine();
  const cv::Mat whole = scene_.flow.clone();
  move (1.5f);
  tuning_.tile = 48;
  refine();
  cv::Mat difference;
  cv::absdiff (whole, scene_.flow, difference);
  EXPECT_LT (cv::mean (difference)[0], 0.05);
  EXPECT_GT (cv::norm (difference, cv::NORM_INF), 0.0);
}

TEST_F (Wall, PointsThatMoveOtherwiseAreAskedFor)
{
  move (1.5f);
  EXPECT_EQ (cv::countNonZero (pointsToRefine (scene_, tuning_, 1)),
             (kWidth - kBorder - 1) * kHeight); // the last column leaves the image
}

TEST_F (Wall, AllPointsWhereNoBodyIsCommon)
{
  move (1.5f);
  scene_.segments[0].points = 100;
  EXPECT_EQ (cv::countNonZero (pointsToRefine (scene_, tuning_, 1)),
             (kWidth - 1) * kHeight);
}

TEST_F (Wall, UndeterminedSegmentsAreNotAsked)
{
  move (1.5f);
  scene_.segments[1].status = MotionStatus::Undetermined;
  EXPECT_TRUE (pointsToRefine (scene_, tuning_, 1).empty());
}

} // namespace
