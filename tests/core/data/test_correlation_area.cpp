// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/data/correlation_area.h"
#include "support/points.h"

#include <random>

namespace {

using namespace pcl_msf;

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr float kSigmaDepth = 0.001f;    // 1 / metres
constexpr float kSigmaIntensity = 1e-4f; // far below the gradient

/** Noise that is the same all over squares. */
cv::Mat
blockNoise (int side, double sigma)
{
  std::mt19937 random (7);
  std::normal_distribution<float> normal (0.0f, static_cast<float> (sigma));
  cv::Mat blocks (kHeight / side, kWidth / side, CV_32FC1);
  for (auto value = blocks.begin<float>(); value != blocks.end<float>(); ++value)
    *value = normal (random);
  cv::Mat noise (kHeight, kWidth, CV_32FC1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      noise.at<float> (y, x) = blocks.at<float> (y / side, x / side);
  return noise;
}

/** A wall at rest, 2 m away, whose brightness rises to the right and down. */
FrameLevel
wall ()
{
  FrameLevel level;
  level.camera = {300.0, 300.0, 0.5 * (kWidth - 1), 0.5 * (kHeight - 1)};
  level.inverse_depth = cv::Mat (kHeight, kWidth, CV_32FC1, cv::Scalar (0.5));
  level.normals = cv::Mat (kHeight, kWidth, CV_32FC3, cv::Scalar (0, 0, -1));
  level.intensity.create (kHeight, kWidth, CV_32FC1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      level.intensity.at<float> (y, x) = 0.001f * static_cast<float> (x + y);
  return level;
}

/** What is measured with noise of these sizes and strengths on the current frame. */
CorrelationAreas
measured (int depth_side, int bright_side, double strength = 1.0, int level = 0)
{
  FrameLevel current = wall();
  current.inverse_depth += blockNoise (depth_side, strength * kSigmaDepth);
  current.intensity += blockNoise (bright_side, strength * kSigmaIntensity);
  NoiseModel noise;
  noise.intensity = kSigmaIntensity;
  noise.displacement = 0.0;
  noise.inverse_depth = kSigmaDepth;
  noise.relative_depth = 0.0;
  const SegmentPixels pixels = test::pointsOf (
      wall(), cv::Mat (kHeight, kWidth, CV_32SC1, cv::Scalar (0)), 1, noise, 0.05);
  EnergyParameters energy;
  energy.loss = LossType::L2;
  const Texture texture (current);
  DataTerm data (pixels, texture, makeRules (energy, pixels, {}), 1);
  const WindowState state (MotionState::fromSegments ({RigidPose{}}, 0));
  return measureCorrelationAreas (
      {{0, &data, &data, 1.0}}, state, level, {7.0, 9.0}, {}, 2);
}

TEST (CorrelationArea, WhiteNoiseAsModelledIsOnePixel)
{
  const CorrelationAreas areas = measured (1, 1);
  EXPECT_NEAR (areas.icp, 1.0, 0.3);
  // Tiles of 300 squares: the median's error is about 10 %. Sampling whole pixels
  // keeps white noise white.
  EXPECT_NEAR (areas.brightness, 1.0, 0.3);
}

TEST (CorrelationArea, NoiseOfAWindowIsWorthTheWindow)
{
  const CorrelationAreas areas = measured (4, 1);
  EXPECT_NEAR (areas.icp, 16.0, 5.0);
  EXPECT_NEAR (areas.brightness, 1.0, 0.3);
  EXPECT_NEAR (measured (1, 4).brightness, 16.0, 6.0);
}

TEST (CorrelationArea, StrongerNoiseThanModelledCountsBySquares)
{
  EXPECT_NEAR (measured (4, 1, 2.0).icp, 64.0, 20.0);
  EXPECT_NEAR (measured (1, 1, 2.0).icp, 4.0, 1.2);
}

TEST (CorrelationArea, IsNeverBelowAPixel)
{
  const CorrelationAreas areas = measured (1, 1, 0.1);
  EXPECT_EQ (areas.icp, 1.0);
  EXPECT_EQ (areas.brightness, 1.0);
}

TEST (CorrelationArea, APixelOfACoarseLevelStandsForSeveral)
{
  // The same noise as on level 0, of which a pixel holds four.
  EXPECT_NEAR (measured (1, 1, 1.0, 1).icp, 4.0, 1.2);
}

TEST (CorrelationArea, StaysWhereNothingIsSeen)
{
  FrameLevel empty = wall();
  empty.inverse_depth.setTo (0.0);
  const SegmentPixels pixels = test::pointsOf (
      wall(), cv::Mat (kHeight, kWidth, CV_32SC1, cv::Scalar (0)), 1, {}, 0.05);
  const Texture texture (empty);
  DataTerm data (pixels, texture, makeRules ({}, pixels, {}), 1);
  const WindowState state (MotionState::fromSegments ({RigidPose{}}, 0));
  const CorrelationAreas areas =
      measureCorrelationAreas ({{0, &data, &data, 1.0}}, state, 0, {7.0, 9.0}, {}, 1);
  EXPECT_EQ (areas.brightness, 7.0);
  EXPECT_EQ (areas.icp, 9.0);
}

TEST (CorrelationArea, WeighsTheTermsAndNotTheirRatioToProbes)
{
  SegmentPixels pixels = test::pointsOf (
      wall(), cv::Mat (kHeight, kWidth, CV_32SC1, cv::Scalar (0)), 1, {}, 0.05);
  const kernel::Rules before = makeRules ({}, pixels, {});
  const double scale = residualScale ({}, pixels);
  pixels.areas = {10.0, 100.0};
  const kernel::Rules after = makeRules ({}, pixels, {});
  EXPECT_FLOAT_EQ (after.brightness_weight, before.brightness_weight / 10.0f);
  EXPECT_FLOAT_EQ (after.icp_weight, before.icp_weight / 100.0f);
  // Energy times the scale: half the squared deviations over independent residuals.
  EXPECT_DOUBLE_EQ (residualScale ({}, pixels), scale);
  pixels.pixel_area = 16; // level 2: four of its pixels' errors are alike, not 100
  EXPECT_DOUBLE_EQ (residualScale ({}, pixels), 16.0 * scale);
}

} // namespace
