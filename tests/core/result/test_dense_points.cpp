// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/result/dense_points.h"
#include "core/result/dense_visibility.h"
#include "support/bending_wall.h"
#include "support/points.h"
#include <pcl_msf/rgbd_frame.h>

#include <random>
#include <type_traits>

namespace {

using namespace pcl_msf;
using test::BendingWall;

constexpr double kSlide = 4.0; // pixels
constexpr double kMetres = kSlide * BendingWall::kDepth / 150.0;

/** Two tiles, the left one at rest, the right one sliding; middles at columns 9.5 and
 * 29.5. */
class Blended : public testing::Test {
protected:
  Blended()
  {
    scene_.camera = wall_.camera;
    scene_.labels = wall_.labels;
    const MotionState state = wall_.truth();
    for (int k = 0; k < 2; ++k) {
      SegmentMotion motion;
      motion.current_from_reference = state.poseOf (k);
      motion.status = MotionStatus::Determined;
      motion.points = wall_.pixels.size (k);
      motion.group = k;
      motion.centroid = wall_.pixels.centroid[k];
      scene_.segments.push_back (motion);
    }
    scene_.pairs.push_back ({0, 1, 0.0, 1.0});
  }

  /** How far the point at a column has slid, as a share of the right tile's way. */
  double
  slideAt (int column, bool blend = true)
  {
    BlendTuning tuning;
    tuning.reach = 0.5;
    fillPoints (wall_.pixels, wall_.camera, blend, tuning, 1, scene_);
    return scene_.displacement.at<cv::Vec3f> (10, column)[1] / kMetres;
  }

  BendingWall wall_{2, 1, [] (double x) {
                      return test::WallShift{x < 19.75 ? 0.0 : kSlide, 0.0};
                    }};
  SceneFlow scene_;
};

// Both tiles hold 400 points, so that the weights fall off with a deviation of 10
// pixels, half a side: at column 19, exp (-9.5^2 / 200) and exp (-10.5^2 / 200).
TEST_F (Blended, PointsBetweenSoftTilesMoveByAMean)
{
  EXPECT_NEAR (slideAt (19), 1.0 / (1.0 + std::exp (0.1)), 1e-4);
  EXPECT_NEAR (slideAt (20), 1.0 / (1.0 + std::exp (-0.1)), 1e-4);
  EXPECT_NEAR (slideAt (9), 1.0 / (1.0 + std::exp (2.1)), 1e-4);
  const float pixels = scene_.flow.at<cv::Vec2f> (10, 19)[1];
  EXPECT_NEAR (pixels, kSlide / (1.0 + std::exp (0.1)), 1e-3);
}

TEST_F (Blended, MixingIsTheOthersStrength)
{
  scene_.pairs[0].mixing = 0.5;
  EXPECT_NEAR (slideAt (19), 0.5 / (0.5 + std::exp (0.1)), 1e-4);
  EXPECT_NEAR (slideAt (20), 1.0 / (1.0 + 0.5 * std::exp (-0.1)), 1e-4);
}

TEST_F (Blended, SharpTilesMoveAlone)
{
  scene_.pairs[0].weight = 1.0; // the lifting weight has no say
  scene_.pairs[0].mixing = 0.0;
  EXPECT_NEAR (slideAt (19), 0.0, 1e-6);
  EXPECT_NEAR (slideAt (20), 1.0, 1e-6);
}

TEST_F (Blended, NothingBlendsUnlessAsked)
{
  EXPECT_NEAR (slideAt (19, false), 0.0, 1e-6);
  EXPECT_NEAR (slideAt (20, false), 1.0, 1e-6);
}

TEST_F (Blended, BodiesOfOneGroupBlendByTheirMotions)
{
  scene_.segments[1].group = 0;
  EXPECT_NEAR (slideAt (19), 1.0 / (1.0 + std::exp (0.1)), 1e-4);
  // Equal motions stay exactly what they are.
  scene_.segments[1].group = 1;
  scene_.segments[1].current_from_reference =
      scene_.segments[0].current_from_reference =
          test::turnAbout ({0.1, 0.2, 2.0}, {0.01, 0.02, 0.03}, {0.1, 0.2, 0.3});
  slideAt (19);
  const cv::Mat blended = scene_.displacement.clone();
  slideAt (19, false);
  EXPECT_EQ (cv::norm (blended, scene_.displacement, cv::NORM_INF), 0.0);
}

TEST_F (Blended, UncertainMotionsAreNotPassedOn)
{
  scene_.segments[1].status = MotionStatus::Supported;
  EXPECT_NEAR (slideAt (19), 0.0, 1e-6);
  EXPECT_NEAR (slideAt (20), 1.0 / (1.0 + std::exp (-0.1)), 1e-4);
  scene_.segments[1].status = MotionStatus::Undetermined;
  slideAt (19);
  EXPECT_TRUE (std::isnan (scene_.displacement.at<cv::Vec3f> (10, 20)[1]));
  EXPECT_TRUE (std::isnan (scene_.flow.at<cv::Vec2f> (10, 20)[0]));
}

TEST_F (Blended, SameForAnyNumberOfThreads)
{
  slideAt (19);
  const cv::Mat one = scene_.displacement.clone();
  for (const int threads : {2, 5}) {
    fillPoints (wall_.pixels, wall_.camera, true, {}, threads, scene_);
    EXPECT_EQ (cv::norm (one, scene_.displacement, cv::NORM_INF), 0.0);
  }
}

// Visible is what lies within the noise of the surface that the other frame shows.

constexpr int kWidth = 60;
constexpr int kHeight = 40;
constexpr float kDepth = 2.0f;

/** A wall at rest, two metres away, in one segment; the other frame's depth is the
 * test's. */
class WallAtRest : public testing::Test {
protected:
  WallAtRest()
  {
    scene_.camera = {60.0, 60.0, 29.5, 19.5};
    scene_.labels = cv::Mat (kHeight, kWidth, CV_32SC1, cv::Scalar (0));
    scene_.displacement = cv::Mat (kHeight, kWidth, CV_32FC3, cv::Scalar::all (0.0));
    scene_.segments.resize (1);
    scene_.segments[0].status = MotionStatus::Determined;
  }

  RgbdFrame
  frame (const cv::Mat& depth) const
  {
    return RgbdFrame::fromImages (cv::Mat(), depth, scene_.camera, {});
  }

  /** \param noise of the inverse depth, 1 / metres */
  void
  look (double noise = 0.0)
  {
    const FrameLevel wall =
        frame (cv::Mat (kHeight, kWidth, CV_32FC1, cv::Scalar (kDepth))).levels()[0];
    NoiseModel model;
    model.inverse_depth = noise;
    const SegmentPixels pixels = test::pointsOf (wall, scene_.labels, 1, model, 0.01);
    scene_.points = cv::Mat (kHeight, kWidth, CV_32FC3);
    for (std::size_t i = 0; i < pixels.pixel.size(); ++i)
      scene_.points.ptr<cv::Vec3f>()[pixels.pixel[i]] = {
          pixels.x[i], pixels.y[i], pixels.z[i]};
    const RgbdFrame current = frame (shown_);
    const Texture texture (current.levels()[0]);
    fillVisibility (pixels, texture.image(), {}, 1, scene_);
  }

  int
  at (int row, int column) const
  {
    return scene_.visibility.at<unsigned char> (row, column);
  }
  int
  count (Visibility kind) const
  {
    return cv::countNonZero (scene_.visibility == pixelValue (kind));
  }

  cv::Mat shown_{kHeight, kWidth, CV_32FC1, cv::Scalar (kDepth)};
  SceneFlow scene_;
};

TEST (Visibilities, ArePixelsOfAnImage)
{
  const cv::Mat image =
      (cv::Mat_<unsigned char> (1, 3) << 0, 255, pixelValue (Visibility::Occluded));
  EXPECT_TRUE (image.data[0] == Visibility::NoDepth);
  EXPECT_TRUE (Visibility::Visible == image.data[1]);
  EXPECT_TRUE (image.data[1] != Visibility::Occluded);
  EXPECT_TRUE (Visibility::Visible != image.data[2]);
  EXPECT_FALSE (image.data[2] != Visibility::Occluded);
  EXPECT_FALSE (image.data[2] == Visibility::Unknown);
  EXPECT_EQ (cv::countNonZero (image == pixelValue (Visibility::Visible)), 1);
  static_assert (pixelValue (Visibility::OutOfView) == 64, "what files hold");
  static_assert (!std::is_convertible_v<Visibility, int>, "no number by itself");
}

TEST_F (WallAtRest, IsVisible)
{
  look();
  EXPECT_EQ (count (Visibility::Visible), kWidth * kHeight);
  EXPECT_EQ (scene_.segments[0].visible_points, kWidth * kHeight);
}

TEST_F (WallAtRest, BehindAnotherSurfaceIsOccluded)
{
  shown_ (cv::Rect (10, 10, 20, 20)) = 1.9f;
  look();
  EXPECT_EQ (at (20, 20), Visibility::Occluded);
  EXPECT_EQ (count (Visibility::Occluded), 400);
  EXPECT_EQ (scene_.segments[0].visible_points, kWidth * kHeight - 400);
}

TEST_F (WallAtRest, BeforeAFartherSurfaceIsNotVisible)
{
  shown_ (cv::Rect (10, 10, 20, 20)) = 2.1f; // what was there has gone
  look();
  EXPECT_EQ (at (20, 20), Visibility::Unknown);
  EXPECT_EQ (count (Visibility::Visible), kWidth * kHeight - 400);
}

TEST_F (WallAtRest, OneMeasurementAmongOthersIsNoSurface)
{
  shown_ (cv::Rect (10, 10, 20, 20)) = 3.0f;
  shown_.at<float> (20, 20) = kDepth;
  look();
  EXPECT_EQ (at (20, 20), Visibility::Unknown);
}

TEST_F (WallAtRest, OneMeasurementAmongNoneIsSeen)
{
  shown_ (cv::Rect (10, 10, 20, 20)) = 0.0f;
  shown_.at<float> (20, 20) = kDepth;
  look();
  EXPECT_EQ (at (20, 20), Visibility::Visible);
  EXPECT_EQ (count (Visibility::Unknown), 399);
}

TEST_F (WallAtRest, OutOfViewAndUndeterminedAreSaid)
{
  scene_.displacement.at<cv::Vec3f> (5, 5) = {-10.0f, 0.0f, 0.0f};
  look();
  EXPECT_EQ (at (5, 5), Visibility::OutOfView);
  scene_.segments[0].status = MotionStatus::Undetermined;
  look();
  EXPECT_EQ (count (Visibility::Unknown), kWidth * kHeight);
  EXPECT_EQ (scene_.segments[0].visible_points, 0);
}

/** Noise that neighbours share hides from the frames' estimates, not from the
 * residuals. */
TEST_F (WallAtRest, SharedNoiseWidensWhatIsVisible)
{
  std::mt19937 random (1);
  std::normal_distribution<float> noise (0.0f, 0.006f); // 1 / metres: 1.2 %
  for (int y = 0; y < kHeight; y += 5)
    for (int x = 0; x < kWidth; x += 5)
      shown_ (cv::Rect (x, y, 5, 5)) = 1.0f / (1.0f / kDepth + noise (random));
  look();
  EXPECT_GT (count (Visibility::Visible), 0.9 * kWidth * kHeight);
}

/** However large the noise is said to be: a tenth of the depth is another surface. */
TEST_F (WallAtRest, NoNoiseMakesEverythingVisible)
{
  shown_ (cv::Rect (0, 0, 30, kHeight)) = 1.0f;
  shown_ (cv::Rect (30, 0, 30, kHeight)) = 4.0f;
  look (1.0);
  EXPECT_EQ (count (Visibility::Visible), 0);
  EXPECT_EQ (count (Visibility::Occluded), 30 * kHeight);
}

} // namespace
