// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Core>

#include <opencv2/imgproc.hpp>

#include "core/start/far_motions.h"

#include <random>
#include <vector>

namespace {

using namespace pcl_msf;

const PinholeCamera kCamera{300.0, 300.0, 159.5, 119.5};
const RigidFitOptions kOptions{kCamera, 1e-3, 1e-3, {}};

/** A point and where it goes by a motion. */
FlowSample
matchOf (const Eigen::Vector3d& p, const RigidPose& pose)
{
  const Eigen::Vector3d q = pose * p;
  return {static_cast<float> (p.x()),
          static_cast<float> (p.y()),
          static_cast<float> (p.z()),
          static_cast<float> (kCamera.fx * q.x() / q.z() + kCamera.cx),
          static_cast<float> (kCamera.fy * q.y() / q.z() + kCamera.cy),
          static_cast<float> (1.0 / q.z())};
}

class MatchedMotions : public testing::Test {
protected:
  MatchedMotions()
  {
    first_.parameters = {0.0, 0.2, 0.0, 0.8, 0.0, 0.1};
    second_.parameters = {0.1, 0.0, 0.3, -0.5, 0.4, 0.0};
    for (int i = 0; i < 60; ++i)
      matches_.push_back (matchOf (point (-1.0), first_));
    for (int i = 0; i < 30; ++i)
      matches_.push_back (matchOf (point (1.0), second_));
  }

  /** Of a cube of one metre about x. */
  Eigen::Vector3d
  point (double x)
  {
    return {x + uniform_ (random_), uniform_ (random_), 3.0 + uniform_ (random_)};
  }

  void
  addWrong (int count)
  {
    for (int i = 0; i < count; ++i) {
      FlowSample wrong = matchOf (point (0.0), RigidPose{});
      wrong.u = static_cast<float> (320.0 * (uniform_ (random_) + 0.5));
      wrong.v = static_cast<float> (240.0 * (uniform_ (random_) + 0.5));
      matches_.push_back (wrong);
    }
  }

  static void
  expectNear (const RigidPose& found, const RigidPose& truth, const Eigen::Vector3d& at)
  {
    EXPECT_LT ((found * at - truth * at).norm(), 0.01);
    EXPECT_LT ((found.rotation() - truth.rotation()).norm(), 0.01);
  }

  std::mt19937 random_{7};
  std::uniform_real_distribution<double> uniform_{-0.5, 0.5};
  RigidPose first_, second_;
  std::vector<FlowSample> matches_;
};

TEST_F (MatchedMotions, AreFoundTheLargestFirstAmongWrongMatches)
{
  addWrong (40);
  const auto motions = motionsOfMatches (matches_, RigidPose{}, kOptions, {}, 2);
  ASSERT_EQ (motions.size(), 2U);
  expectNear (motions[0], first_, {-1.0, 0.0, 3.0});
  expectNear (motions[1], second_, {1.0, 0.0, 3.0});
}

TEST_F (MatchedMotions, WrongMatchesAgreeOnNothing)
{
  matches_.clear();
  addWrong (100);
  EXPECT_TRUE (motionsOfMatches (matches_, RigidPose{}, kOptions, {}, 2).empty());
  matches_.clear();
  EXPECT_TRUE (motionsOfMatches (matches_, RigidPose{}, kOptions, {}, 2).empty());
}

TEST_F (MatchedMotions, DoNotDependOnThreads)
{
  addWrong (40);
  const auto one = motionsOfMatches (matches_, RigidPose{}, kOptions, {}, 1);
  const auto four = motionsOfMatches (matches_, RigidPose{}, kOptions, {}, 4);
  ASSERT_EQ (one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ (one[i].parameters, four[i].parameters);
}

/** A wall with blobs at 2 m, seen through a window of a wider picture. */
class FarWall : public testing::Test {
protected:
  FarWall() : picture_ (240, 520, CV_8UC1, cv::Scalar (90))
  {
    cv::RNG random (3);
    for (int i = 0; i < 900; ++i)
      cv::circle (picture_,
                  {random.uniform (0, 520), random.uniform (0, 240)},
                  random.uniform (2, 9),
                  random.uniform (0, 255),
                  cv::FILLED,
                  cv::LINE_AA);
  }

  RgbdFrame
  frameAt (int x) const
  {
    const cv::Mat depth (240, 320, CV_32FC1, cv::Scalar (2.0f));
    return RgbdFrame::fromImages (
        picture_ (cv::Rect (x, 0, 320, 240)).clone(), depth, kCamera);
  }

  /** The flow of a wall that moves by pixels to the left. */
  static CoarseFlow
  flowBy (float pixels)
  {
    return {cv::Mat (240, 320, CV_32FC2, cv::Scalar (-pixels, 0.0)), 0};
  }

  cv::Mat picture_;
};

TEST_F (FarWall, IsFoundWhereOpticalFlowFailed)
{
  const FarMotions far =
      findFarMotions (frameAt (0), frameAt (150), flowBy (0), {}, kOptions, {}, 2);
  EXPECT_TRUE (far.instead_of_flow);
  ASSERT_FALSE (far.motions.empty());
  const Eigen::Vector3d moved = far.motions[0] * Eigen::Vector3d (0.5, 0.0, 2.0);
  EXPECT_NEAR (moved.x(), 0.5 - 150.0 * 2.0 / kCamera.fx, 0.01);
  EXPECT_NEAR (moved.z(), 2.0, 0.01);
}

TEST_F (FarWall, IsNothingNewWhereOpticalFlowIsRight)
{
  const FarMotions far =
      findFarMotions (frameAt (0), frameAt (150), flowBy (150), {}, kOptions, {}, 2);
  EXPECT_FALSE (far.instead_of_flow);
  EXPECT_TRUE (far.motions.empty());
}

TEST_F (FarWall, IsNotFoundInAnImageWithoutFeatures)
{
  picture_.setTo (90);
  const FarMotions far =
      findFarMotions (frameAt (0), frameAt (150), flowBy (0), {}, kOptions, {}, 2);
  EXPECT_FALSE (far.instead_of_flow);
  EXPECT_TRUE (far.motions.empty());
}

} // namespace
