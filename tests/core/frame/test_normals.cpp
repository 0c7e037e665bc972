// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/frame/normals.h"
#include "support/slanted_plane.h"
#include <pcl_msf/rgbd_frame.h>

#include <cmath>
#include <random>

namespace {

using namespace pcl_msf;

constexpr int kWidth = test::SlantedPlane::kWidth;
constexpr int kHeight = test::SlantedPlane::kHeight;
const test::SlantedPlane kPlane;
const PinholeCamera kCamera = kPlane.camera;
const Eigen::Vector3d kNormal = kPlane.normal;

class Normals : public testing::TestWithParam<NormalMethod> {
protected:
  static RgbdFrame
  frame (const cv::Mat& depth)
  {
    FrameParameters parameters;
    parameters.normals = GetParam();
    return RgbdFrame::fromImages ({}, depth, kCamera, parameters);
  }
};

TEST_P (Normals, OfASlantedPlaneAreExact)
{
  const cv::Mat normals = frame (kPlane.depth()).levels()[0].normals;
  const int border = GetParam() == NormalMethod::CentralDifferences ? 0 : 12;
  for (int y = border; y < kHeight - border; ++y)
    for (int x = border; x < kWidth - border; ++x) {
      const cv::Vec3f n = normals.at<cv::Vec3f> (y, x);
      const Eigen::Vector3d found (n[0], n[1], n[2]);
      EXPECT_NEAR (found.norm(), 1.0, 1e-5);
      EXPECT_LT (found.cross (kNormal).norm(), 1e-3) << x << " " << y;
      EXPECT_GT (found.dot (kNormal), 0.0);
    }
}

TEST_P (Normals, PointTowardsTheCamera)
{
  const cv::Mat depth = test::image (kWidth, kHeight, [] (int x, int y) {
    return 2.0 + 0.2 * std::sin (0.15 * x) * std::cos (0.12 * y);
  });
  const cv::Mat normals = frame (depth).levels()[0].normals;
  int known = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const cv::Vec3f n = normals.at<cv::Vec3f> (y, x);
      const Eigen::Vector3d ray = kCamera.backProject (x, y, 1.0);
      EXPECT_LE (Eigen::Vector3d (n[0], n[1], n[2]).dot (ray), 0.0);
      known += n[2] < 0.0f ? 1 : 0;
    }
  EXPECT_GT (known, kWidth * kHeight / 2);
}

TEST_P (Normals, DoNotReachAcrossADepthEdge)
{
  const cv::Mat normals = frame (kPlane.step (1.0, 3.0, 48)).levels()[0].normals;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const cv::Vec3f n = normals.at<cv::Vec3f> (y, x);
      const bool none = n == cv::Vec3f (0, 0, 0);
      EXPECT_TRUE (none || n[2] < -0.999f) << x << " " << y << " " << n;
    }
}

TEST_P (Normals, HolesHaveNone)
{
  cv::Mat depth = kPlane.depth();
  depth (cv::Rect (30, 30, 5, 5)) = 0.0f;
  const cv::Mat normals = frame (depth).levels()[0].normals;
  EXPECT_EQ (normals.at<cv::Vec3f> (32, 32), cv::Vec3f (0, 0, 0));
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      EXPECT_FALSE (std::isnan (normals.at<cv::Vec3f> (y, x)[0]));
}

INSTANTIATE_TEST_SUITE_P (Methods,
                          Normals,
                          testing::Values (NormalMethod::CentralDifferences,
                                           NormalMethod::IntegralImage));

TEST (Normals, OwnOnesAreMadeUnitOrNone)
{
  cv::Mat own (kHeight, kWidth, CV_32FC3, cv::Scalar (0, 0, -2));
  own.at<cv::Vec3f> (3, 4) = {NAN, 0, -1};
  const RgbdFrame frame =
      RgbdFrame::fromImages ({}, kPlane.constant (2.0), kCamera, {}, own);
  EXPECT_EQ (frame.levels()[0].normals.at<cv::Vec3f> (0, 0), cv::Vec3f (0, 0, -1));
  EXPECT_EQ (frame.levels()[0].normals.at<cv::Vec3f> (3, 4), cv::Vec3f (0, 0, 0));
}

TEST (CentralDifferences, FindAFloorAtAGrazingAngle)
{
  // 1.2 m above a floor, level: row y shows it at z = 1.2 f / (y - cy), so that inverse
  // depth changes by 1 / (y - cy) of itself per row.
  const PinholeCamera camera{262.0, 262.0, 47.5, 0.0};
  constexpr int kNearest = 12; // rows below the horizon: 26 m
  const cv::Mat depth = test::image (
      96, 80, [&] (int, int y) { return y < 4 ? std::nan ("") : 1.2 * camera.fy / y; });
  const RgbdFrame frame = RgbdFrame::fromImages ({}, depth, camera);
  const cv::Mat normals = frame.levels()[0].normals;
  for (int y = kNearest; y < 79; ++y)
    for (int x = 0; x < 96; ++x)
      EXPECT_LT (cv::norm (normals.at<cv::Vec3f> (y, x) - cv::Vec3f (0, -1, 0)), 1e-3)
          << x << " " << y;
}

TEST (CentralDifferences, AllInstructionSetsGiveTheSameBits)
{
  std::mt19937 random (5);
  std::normal_distribution<double> noise (0.0, 2e-3);
  const cv::Mat inverse_depth = test::image (171, 40, [&] (int x, int y) {
    const double w = x < 90 ? 0.5 + 0.001 * y : 0.8 - 0.002 * x;
    return (x + y) % 17 == 0 ? 0.0 : w + noise (random);
  });
  for (const double level : {1e-4, 2e-3}) { // narrow and wide windows
    const auto by = [&] (InstructionSet set) {
      return normalsByCentralDifferences (inverse_depth, kCamera, level, {}, set);
    };
    const cv::Mat plain = by (InstructionSet::Default);
    EXPECT_GT (cv::countNonZero (plain.reshape (1) != 0.0f), 3 * 171 * 20);
    for (const InstructionSet set : usableInstructionSets())
      EXPECT_EQ (cv::norm (by (set), plain, cv::NORM_INF), 0.0) << nameOf (set);
  }
}

TEST (NormalMethods, NoneLeavesThemOut)
{
  FrameParameters parameters;
  parameters.normals = NormalMethod::Skip;
  const RgbdFrame frame =
      RgbdFrame::fromImages ({}, kPlane.depth(), kCamera, parameters);
  for (const FrameLevel& level : frame.levels())
    EXPECT_EQ (cv::norm (level.normals), 0.0);
}

} // namespace
