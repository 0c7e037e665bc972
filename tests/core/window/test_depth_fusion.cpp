// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/window/depth_fusion.h"
#include "core/window/exposure.h"

#include <cmath>
#include <random>

namespace {

using namespace pcl_msf;

constexpr int kWidth = 64;
constexpr int kHeight = 48;
constexpr double kTruth = 0.5; // 1 / metres, of a wall before a camera that moves aside
constexpr double kSigma = 0.004;

FrameLevel
wall (double inverse_depth, double noise, unsigned seed)
{
  FrameLevel level;
  level.camera = {60.0, 60.0, 31.5, 23.5};
  level.inverse_depth = cv::Mat (kHeight, kWidth, CV_32FC1, cv::Scalar (inverse_depth));
  std::mt19937 generator (seed);
  std::normal_distribution<float> normal (0.0F, static_cast<float> (noise));
  for (int i = 0; noise > 0.0 && i < kWidth * kHeight; ++i)
    level.inverse_depth.ptr<float>()[i] += normal (generator);
  return level;
}

NoiseModel
noiseModel ()
{
  NoiseModel noise;
  noise.inverse_depth = kSigma;
  return noise;
}

MotionState
aside ()
{
  RigidPose pose;
  pose.parameters[3] = 0.12;
  return MotionState::fromSegments ({pose}, 0);
}

double
rootMeanSquare (const cv::Mat& inverse_depth)
{
  double sum = 0.0;
  int count = 0;
  for (int y = 8; y < kHeight - 8; ++y)
    for (int x = 8; x < kWidth - 16; ++x, ++count)
      sum += std::pow (inverse_depth.at<float> (y, x) - kTruth, 2);
  return std::sqrt (sum / count);
}

cv::Mat
fuse (const FrameLevel& reference,
      const cv::Mat& labels,
      const std::vector<DepthSource>& sources,
      int threads)
{
  DepthFusion fusion (reference, labels);
  for (const DepthSource& source : sources)
    fusion.add (source, noiseModel(), {}, threads);
  return fusion.average();
}

TEST (DepthFusion, AveragesIndependentMeasurements)
{
  const FrameLevel reference = wall (kTruth, kSigma, 1);
  const FrameLevel second = wall (kTruth, kSigma, 2);
  const FrameLevel third = wall (kTruth, kSigma, 3);
  const cv::Mat labels = cv::Mat::zeros (kHeight, kWidth, CV_32SC1);
  const double before = rootMeanSquare (reference.inverse_depth);
  const cv::Mat two = fuse (reference, labels, {{&second, aside()}}, 2);
  const cv::Mat three =
      fuse (reference, labels, {{&second, aside()}, {&third, aside()}}, 2);
  EXPECT_NEAR (before, kSigma, 0.1 * kSigma);
  EXPECT_LT (rootMeanSquare (two), 0.75 * before);   // 0.71 for independent ones
  EXPECT_LT (rootMeanSquare (three), 0.62 * before); // 0.58
}

TEST (DepthFusion, IsEmptyBeforeAFrameWasAdded)
{
  const FrameLevel reference = wall (kTruth, kSigma, 1);
  EXPECT_TRUE (
      fuse (reference, cv::Mat::zeros (kHeight, kWidth, CV_32SC1), {}, 1).empty());
}

TEST (DepthFusion, LeavesOutWhatIsAnotherSurface)
{
  const FrameLevel reference = wall (kTruth, 0.0, 1);
  const FrameLevel nearer = wall (kTruth + 0.1, 0.0, 2);
  const cv::Mat labels = cv::Mat::zeros (kHeight, kWidth, CV_32SC1);
  const cv::Mat fused = fuse (reference, labels, {{&nearer, aside()}}, 1);
  EXPECT_EQ (rootMeanSquare (fused), 0.0);
}

TEST (DepthFusion, MovesWithTheSurface)
{
  // The wall comes nearer by 0.4 m, as the pose says: nothing to correct.
  const FrameLevel reference = wall (kTruth, 0.0, 1);
  const FrameLevel nearer = wall (1.0 / (1.0 / kTruth - 0.4), 0.0, 2);
  RigidPose pose;
  pose.parameters[5] = -0.4;
  const cv::Mat labels = cv::Mat::zeros (kHeight, kWidth, CV_32SC1);
  const cv::Mat fused =
      fuse (reference, labels, {{&nearer, MotionState::fromSegments ({pose}, 0)}}, 1);
  EXPECT_LT (rootMeanSquare (fused), 1e-6);
}

TEST (DepthFusion, PointsWithoutLabelOrDepthStay)
{
  FrameLevel reference = wall (kTruth, 0.0, 1);
  reference.inverse_depth.at<float> (20, 20) = 0.0F;
  const FrameLevel second = wall (kTruth + 0.004, 0.0, 2);
  cv::Mat labels = cv::Mat::zeros (kHeight, kWidth, CV_32SC1);
  labels.at<int> (20, 30) = -1;
  const cv::Mat fused = fuse (reference, labels, {{&second, aside()}}, 1);
  EXPECT_EQ (fused.at<float> (20, 20), 0.0F);
  EXPECT_EQ (fused.at<float> (20, 30), static_cast<float> (kTruth));
  EXPECT_NEAR (fused.at<float> (20, 25), kTruth + 0.002, 1e-4);
}

TEST (Falloff, IsFoundFromPointsThatMoveAcrossTheImage)
{
  std::mt19937 generator (5);
  std::uniform_real_distribution<float> uniform (0.0F, 1.0F);
  std::normal_distribution<float> normal (0.0F, 0.008F);
  MatchedIntensities matches;
  const BrightnessChange exposure{1.04F, 0.01F};
  constexpr double kFalloff = -0.2;
  for (int i = 0; i < 20000; ++i) {
    const float before = 0.5F * uniform (generator);
    const float after = before + 0.05F * (uniform (generator) - 0.5F);
    const float color = 0.2F + 0.6F * uniform (generator);
    matches.reference_radius2.push_back (before);
    matches.current_radius2.push_back (after);
    matches.reference.push_back (static_cast<float> (color * (1 + kFalloff * before)));
    matches.current.push_back (exposure.gain *
                                   static_cast<float> (color * (1 + kFalloff * after)) +
                               exposure.offset + normal (generator));
  }
  EXPECT_NEAR (fitFalloff ({matches}, {exposure}, {}), kFalloff, 0.05);
  EXPECT_EQ (fitFalloff ({}, {}, {}), 0.0);
}

TEST (Falloff, IsTakenOutWithTheExposure)
{
  FrameLevel level = wall (kTruth, 0.0, 1);
  level.intensity = cv::Mat (kHeight, kWidth, CV_32FC1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double r2 = (std::pow (x - 31.5, 2) + std::pow (y - 23.5, 2)) / 3600.0;
      level.intensity.at<float> (y, x) =
          static_cast<float> (1.1 * 0.5 * (1.0 - 0.3 * r2) + 0.02);
    }
  const cv::Mat flat = correctIntensity (level, {1.1F, 0.02F}, -0.3);
  double least = 0.0;
  double most = 0.0;
  cv::minMaxLoc (flat, &least, &most);
  EXPECT_NEAR (least, 0.5, 1e-5);
  EXPECT_NEAR (most, 0.5, 1e-5);
}

} // namespace
