// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/dense_points.h"
#include "support/bending_wall.h"

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
      motion.body = k;
      motion.centroid = wall_.pixels.centroid[k];
      scene_.segments.push_back (motion);
    }
    scene_.pairs.push_back ({0, 1, 0.0, 1.0});
  }

  /** How far the point at a column has slid, as a share of the right tile's way. */
  double
  slideAt (int column, bool blend = true)
  {
    const MotionState state = wall_.truth();
    fillPoints (wall_.data (state), wall_.camera, blend, 1, scene_);
    return scene_.displacement.at<cv::Vec3f> (10, column)[1] / kMetres;
  }

  BendingWall wall_{2, 1, [] (double x) {
                      return test::WallShift{x < 19.75 ? 0.0 : kSlide, 0.0};
                    }};
  SceneFlow scene_;
};

// Both tiles hold 400 points, so that the weights fall off with a deviation of 10
// pixels: at column 19, exp (-9.5^2 / 200) and exp (-10.5^2 / 200).
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
  scene_.segments[1].body = 0;
  EXPECT_NEAR (slideAt (19), 1.0 / (1.0 + std::exp (0.1)), 1e-4);
  // Equal motions stay exactly what they are.
  scene_.segments[1].body = 1;
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
  const MotionState state = wall_.truth();
  slideAt (19);
  const cv::Mat one = scene_.displacement.clone();
  for (const int threads : {2, 5}) {
    fillPoints (wall_.data (state), wall_.camera, true, threads, scene_);
    EXPECT_EQ (cv::norm (one, scene_.displacement, cv::NORM_INF), 0.0);
  }
}

} // namespace
