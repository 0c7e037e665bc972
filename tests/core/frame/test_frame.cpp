// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/frame/depth_pyramid.h"
#include "core/frame/noise.h"
#include "support/slanted_plane.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/rgbd_frame.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace pcl_msf;
using testing::HasSubstr;

constexpr int kWidth = test::SlantedPlane::kWidth;
constexpr int kHeight = test::SlantedPlane::kHeight;
const test::SlantedPlane kPlane;
const PinholeCamera kCamera = kPlane.camera;
const Eigen::Vector3d kNormal = kPlane.normal;

TEST (InverseDepth, WhatIsNoMeasurementBecomesZero)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const cv::Mat depth =
      (cv::Mat_<float> (1, 9) << nan, inf, -inf, 0, -1, 0.4, 0.5, 4, 5);
  const cv::Mat w = inverseDepth (depth, 0.5, 4.0);
  for (const int i : {0, 1, 2, 3, 4, 5, 8})
    EXPECT_EQ (w.at<float> (0, i), 0.0f) << i;
  EXPECT_FLOAT_EQ (w.at<float> (0, 6), 2.0f);
  EXPECT_FLOAT_EQ (w.at<float> (0, 7), 0.25f);
}

TEST (DepthPyramid, DoesNotMixTwoSurfaces)
{
  for (const int edge : {40, 41}) {
    const RgbdFrame frame =
        RgbdFrame::fromImages ({}, kPlane.step (1.0, 3.0, edge), kCamera, {});
    ASSERT_GE (frame.levels().size(), 2u);
    for (const FrameLevel& level : frame.levels())
      for (int y = 0; y < level.height(); ++y)
        for (int x = 0; x < level.width(); ++x) {
          const float z = 1.0f / level.inverse_depth.at<float> (y, x);
          EXPECT_TRUE (std::abs (z - 1.0f) < 1e-5f || std::abs (z - 3.0f) < 1e-5f) << z;
        }
  }
}

TEST (DepthPyramid, HolesDoNotGrow)
{
  for (const int hole : {20, 21}) {
    cv::Mat depth = kPlane.depth();
    depth.at<float> (hole, hole) = 0.0f;
    const RgbdFrame frame = RgbdFrame::fromImages ({}, depth, kCamera, {});
    EXPECT_EQ (cv::countNonZero (frame.levels()[0].inverse_depth == 0.0f), 1);
    EXPECT_EQ (cv::countNonZero (frame.levels()[1].inverse_depth == 0.0f), 0);
  }
  cv::Mat large = kPlane.constant (2.0);
  large (cv::Rect (20, 20, 9, 9)) = 0.0f;
  const cv::Mat coarse =
      RgbdFrame::fromImages ({}, large, kCamera, {}).levels()[1].inverse_depth;
  EXPECT_EQ (cv::countNonZero (coarse == 0.0f), 9); // 3 x 3 have no neighbour at all
}

TEST (DepthPyramid, LevelsSeeTheSamePlane)
{
  const RgbdFrame frame = RgbdFrame::fromImages ({}, kPlane.depth(), kCamera, {});
  for (std::size_t l = 0; l < frame.levels().size(); ++l) {
    const FrameLevel& level = frame.levels()[l];
    EXPECT_EQ (level.width(), (kWidth + (1 << l) - 1) >> l);
    EXPECT_DOUBLE_EQ (level.camera.fx, kCamera.fx / (1 << l));
    EXPECT_DOUBLE_EQ (level.camera.cy, kCamera.cy / (1 << l));
    // Inside; at the border the average leans inwards.
    for (int y = 1; y + 1 < level.height(); ++y)
      for (int x = 1; x + 1 < level.width(); ++x) {
        const double z = 1.0 / level.inverse_depth.at<float> (y, x);
        const Eigen::Vector3d p = level.camera.backProject (x, y, z);
        EXPECT_NEAR (kNormal.dot (p), -1.8, 1e-4);
      }
  }
}

TEST (Noise, IsMeasuredWithinAFifth)
{
  std::mt19937 generator (5);
  for (const double sigma : {0.004, 0.02}) {
    std::normal_distribution<double> normal (0.0, sigma);
    const cv::Mat intensity = test::image (160, 120, [&] (int x, int y) {
      return 0.5 + 0.2 * std::sin (0.1 * x) * std::cos (0.08 * y) + normal (generator);
    });
    EXPECT_NEAR (estimateIntensityNoise (intensity), sigma, 0.2 * sigma);
    const cv::Mat w = test::image (160, 120, [&] (int x, int y) {
      const double surface = x < 80 ? 0.5 + 1e-3 * x - 5e-4 * y : 0.3;
      return y % 17 == 3 ? 0.0 : surface + 0.1 * normal (generator);
    });
    EXPECT_NEAR (estimateInverseDepthNoise (w), 0.1 * sigma, 0.02 * sigma);
  }
}

TEST (Noise, CleanImagesHaveNone)
{
  EXPECT_LT (estimateInverseDepthNoise (inverseDepth (kPlane.depth(), 0, 1000)), 1e-6);
  EXPECT_EQ (estimateIntensityNoise (kPlane.constant (0.4)), 0.0);
}

TEST (RgbdFrame, TakesEveryKindOfColour)
{
  const cv::Mat depth = kPlane.constant (2.0);
  const cv::Mat gray8 (kHeight, kWidth, CV_8UC1, cv::Scalar (51));
  const cv::Mat bgr (kHeight, kWidth, CV_8UC3, cv::Scalar (51, 51, 51));
  for (const cv::Mat& color : {gray8, bgr, kPlane.constant (0.2)}) {
    const RgbdFrame frame = RgbdFrame::fromImages (color, depth, kCamera);
    ASSERT_TRUE (frame.hasIntensity());
    EXPECT_NEAR (frame.levels()[0].intensity.at<float> (7, 9), 0.2f, 1e-6f);
    EXPECT_EQ (frame.gray().at<unsigned char> (7, 9), 51);
    EXPECT_EQ (frame.color().empty(), color.type() != CV_8UC3);
  }
  EXPECT_FALSE (RgbdFrame::fromImages ({}, depth, kCamera).hasIntensity());
}

TEST (RgbdFrame, KeepsNothingOfTheImages)
{
  cv::Mat depth = kPlane.constant (2.0);
  cv::Mat bgr (kHeight, kWidth, CV_8UC3, cv::Scalar (51, 51, 51));
  const RgbdFrame frame = RgbdFrame::fromImages (bgr, depth, kCamera);
  bgr.setTo (0); // filled anew for the next frame
  depth.setTo (1.0);
  EXPECT_EQ (frame.color().at<cv::Vec3b> (7, 9), cv::Vec3b (51, 51, 51));
  EXPECT_EQ (frame.gray().at<unsigned char> (7, 9), 51);
  EXPECT_EQ (frame.levels()[0].inverse_depth.at<float> (7, 9), 0.5f);
}

struct BadInput {
  const char* name;
  cv::Mat color, depth;
  PinholeCamera camera;
  cv::Mat normals;
  const char* remedy; ///< words that the message must hold
};

std::vector<BadInput>
badInputs ()
{
  const cv::Mat ok = kPlane.constant (2.0);
  return {
      {"empty", {}, {}, kCamera, {}, "CV_32FC1 image in metres"},
      {"depth type", {}, cv::Mat (kHeight, kWidth, CV_16UC1), kCamera, {}, "metres"},
      {"sizes", cv::Mat (9, 9, CV_8UC1), ok, kCamera, {}, "register them"},
      {"colour", cv::Mat (kHeight, kWidth, CV_8UC4), ok, kCamera, {}, "CV_8UC3"},
      {"camera", {}, ok, PinholeCamera{}, {}, "give focal lengths"},
      {"normals", {}, ok, kCamera, cv::Mat (9, 9, CV_32FC3), "CV_32FC3"},
      {"no depth", {}, kPlane.constant (0.0), kCamera, {}, "it is 0 everywhere"},
      {"NaN depth", {}, kPlane.constant (NAN), kCamera, {}, "not a number"},
      {"behind", {}, kPlane.constant (-2.0), kCamera, {}, "it is -2 to -2"},
      {"millimetres",
       {},
       kPlane.constant (2000.0),
       kCamera,
       {},
       "2000 to 2000, outside"},
      {"narrow", {}, ok (cv::Rect (0, 0, 11, 30)), kCamera, {}, "is 11x30, and must"},
      {"raw intensity",
       kPlane.constant (130.0),
       ok,
       kCamera,
       {},
       "normalizeIntensity"}};
}

TEST (RgbdFrame, RefusesBadInputAndNamesTheRemedy)
{
  for (const BadInput& bad : badInputs()) {
    try {
      RgbdFrame::fromImages (bad.color, bad.depth, bad.camera, {}, bad.normals);
      ADD_FAILURE() << bad.name << " was accepted";
    }
    catch (const InvalidInput& error) {
      EXPECT_THAT (error.what(), HasSubstr (bad.remedy)) << bad.name;
    }
  }
}

TEST (RgbdFrame, RefusesBadParametersAndNamesTheirRange)
{
  std::vector<std::pair<FrameParameters, const char*>> bad (9);
  bad[0] = {{}, "smoothing_sigma must be in"};
  bad[0].first.smoothing_sigma = std::nan ("");
  bad[1] = {{}, "smoothing_sigma must be in"};
  bad[1].first.smoothing_sigma = -1;
  bad[2] = {{}, "min_depth must be"};
  bad[2].first.min_depth = -0.1;
  bad[3] = {{}, "max_depth must be greater"};
  bad[3].first.min_depth = bad[3].first.max_depth = 2.0;
  bad[4] = {{}, "max_levels must be in"};
  bad[4].first.max_levels = 0;
  bad[5] = {{}, "max_levels must be in"};
  bad[5].first.max_levels = 11;
  bad[6] = {{}, "finest_level must be in"};
  bad[6].first.finest_level = -1;
  bad[7] = {{}, "finest_level must be in"};
  bad[7].first.finest_level = 5;
  bad[8] = {{}, "finest_level is 3, at which the frame of 96x80 is 12x10"};
  bad[8].first.finest_level = 3;
  for (const auto& [parameters, remedy] : bad) {
    try {
      RgbdFrame::fromImages ({}, kPlane.constant (2.0), kCamera, parameters);
      ADD_FAILURE() << remedy;
    }
    catch (const InvalidInput& error) {
      EXPECT_THAT (error.what(), HasSubstr (remedy));
    }
  }
}

TEST (RgbdFrame, BeginsAtTheFinestLevelAskedFor)
{
  FrameParameters half;
  half.finest_level = 1;
  const cv::Mat color = test::image (
      test::SlantedPlane::kWidth, test::SlantedPlane::kHeight, [] (int x, int y) {
        return 0.5 + 0.3 * std::sin (0.2 * x + 0.1 * y);
      });
  const RgbdFrame whole = RgbdFrame::fromImages (color, kPlane.depth(), kCamera);
  const RgbdFrame frame = RgbdFrame::fromImages (color, kPlane.depth(), kCamera, half);
  EXPECT_EQ (whole.finestLevel(), 0);
  EXPECT_EQ (frame.finestLevel(), 1);
  EXPECT_EQ (frame.width(), test::SlantedPlane::kWidth / 2);
  EXPECT_EQ (frame.gray().size(), frame.levels()[0].intensity.size());
  EXPECT_EQ (frame.camera().fx, 0.5 * kCamera.fx);
  EXPECT_EQ (frame.inputCamera().fx, kCamera.fx);
  EXPECT_EQ (whole.inputCamera().fx, kCamera.fx);
  EXPECT_EQ (
      cv::norm (frame.inputInverseDepth(), whole.inputInverseDepth(), cv::NORM_INF),
      0.0);
  const FrameLevel& level = frame.levels()[0];
  for (int y = 2; y < frame.height() - 2; ++y)
    for (int x = 2; x < frame.width() - 2; ++x) {
      const float w = whole.inputInverseDepth().at<float> (2 * y, 2 * x);
      EXPECT_NEAR (level.inverse_depth.at<float> (y, x), w, 1e-5);
      const cv::Vec3f n = level.normals.at<cv::Vec3f> (y, x);
      EXPECT_NEAR (kNormal.dot (Eigen::Vector3d (n[0], n[1], n[2])), 1.0, 1e-3)
          << x << " " << y;
    }
}

TEST (RgbdFrame, HalvesGivenNormalsAndKeepsTheNoiseOfItsInput)
{
  FrameParameters half;
  half.finest_level = 1;
  const cv::Mat normals (test::SlantedPlane::kHeight,
                         test::SlantedPlane::kWidth,
                         CV_32FC3,
                         cv::Scalar (0, 0, -2));
  cv::Mat depth = kPlane.constant (2.0);
  cv::Mat noise (depth.size(), CV_32FC1);
  cv::RNG (3).fill (noise, cv::RNG::NORMAL, 0.0, 0.01);
  depth += noise;
  const RgbdFrame whole = RgbdFrame::fromImages ({}, depth, kCamera, {}, normals);
  const RgbdFrame frame = RgbdFrame::fromImages ({}, depth, kCamera, half, normals);
  EXPECT_EQ (frame.levels()[0].normals.at<cv::Vec3f> (7, 9), cv::Vec3f (0, 0, -1));
  EXPECT_EQ (frame.inverseDepthNoise(), whole.inverseDepthNoise());
}

TEST (HalveInverseDepth, AllInstructionSetsGiveTheSameBits)
{
  std::mt19937 random (8);
  std::normal_distribution<double> noise (0.0, 2e-3);
  for (const int width : {64, 71}) {
    const cv::Mat fine = test::image (width, 33, [&] (int x, int y) {
      const double w = x < 30 ? 0.5 + 0.001 * y : 0.8 - 0.002 * x;
      return (x * y) % 7 == 0 ? 0.0 : w + noise (random);
    });
    const cv::Mat plain = halveInverseDepth (fine, 1e-3, {}, InstructionSet::Default);
    EXPECT_EQ (plain.size(), cv::Size ((width + 1) / 2, 17));
    for (const InstructionSet set : usableInstructionSets())
      EXPECT_EQ (
          cv::norm (halveInverseDepth (fine, 1e-3, {}, set), plain, cv::NORM_INF), 0.0)
          << nameOf (set);
  }
}

} // namespace
