// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/easy_sequences.h"
#include <pcl_msf/errors.h>

#include <cmath>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::test;

constexpr SceneKind scene = SceneKind::StaticRoom;

double
meanBrightness (const cv::Mat& color)
{
  const cv::Scalar mean = cv::mean (color);
  return mean[0] + mean[1] + mean[2];
}

TEST (CameraEffects, DepthLiesBesideColour)
{
  SequenceOptions options = smallOptions (scene);
  options.effects.depth_shift_x = 3.0;
  options.effects.depth_shift_y = -2.0;
  const SyntheticSequence shifted = synthesize (options);
  const SyntheticSequence& exact = easySequence (scene);
  EXPECT_TRUE (sameBits (shifted.frames[1].color, exact.frames[1].color));
  for (int v = 0; v < height - 2; ++v)
    for (int u = 3; u < width; ++u)
      ASSERT_NEAR (shifted.frames[1].depth.at<float> (v, u),
                   exact.frames[1].depth.at<float> (v + 2, u - 3),
                   1e-5);
}

TEST (CameraEffects, DepthComesLater)
{
  SequenceOptions options = smallOptions (scene);
  options.effects.depth_delay = 1.0;
  const SyntheticSequence late = synthesize (options);
  const SyntheticSequence& exact = easySequence (scene);
  EXPECT_TRUE (sameBits (late.frames[0].color, exact.frames[0].color));
  EXPECT_TRUE (sameBits (late.frames[0].depth, exact.frames[1].depth));
}

TEST (CameraEffects, RollingShutterReadsTheMiddleInTime)
{
  SequenceOptions options = smallOptions (scene, MotionSize::Large);
  const SyntheticSequence exact = synthesize (options);
  options.effects.rolling_shutter = 0.8;
  const SyntheticSequence rolled = synthesize (options);
  const auto difference = [&] (int from, int to) {
    return cv::norm (exact.frames[1].color.rowRange (from, to),
                     rolled.frames[1].color.rowRange (from, to),
                     cv::NORM_L1) /
           (to - from);
  };
  EXPECT_LT (difference (70, 74), 0.2 * difference (0, 4));
  EXPECT_LT (difference (70, 74), 0.2 * difference (140, 144));
  EXPECT_TRUE (sameBits (rolled.truth[1].flow, exact.truth[1].flow));
}

TEST (CameraEffects, LensMovesWhatIsSeen)
{
  SequenceOptions options = smallOptions (scene);
  options.effects.distortion = {-0.2, 0.05, 0.001, -0.002, 0.0};
  const SyntheticSequence bent = synthesize (options);
  const SyntheticSequence& exact = easySequence (scene);
  int all = 0, same = 0;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const Eigen::Vector2d p =
          options.effects.distortion.undistortedPixel (bent.camera, u, v);
      const int x = cvRound (p.x()), y = cvRound (p.y());
      if (x < 0 || y < 0 || x >= width || y >= height)
        continue;
      const double z = exact.frames[0].depth.at<float> (y, x);
      ++all;
      same += std::abs (bent.frames[0].depth.at<float> (v, u) - z) < 0.03 * z;
    }
  EXPECT_GT (all, 0.8 * width * height);
  EXPECT_GT (same, 0.95 * all);
  // Barrel distortion: corners see what lies outside of the ideal image.
  EXPECT_EQ (cv::countNonZero (bent.frames[0].depth > 0.0F), width * height);
  EXPECT_GT (cv::norm (bent.frames[0].depth, exact.frames[0].depth, cv::NORM_INF), 0.1);
}

TEST (CameraEffects, ExposureAndVignetteAreAsAskedFor)
{
  SequenceOptions options = smallOptions (scene);
  options.effects.exposure_change = 0.4;
  const SyntheticSequence changing = synthesize (options);
  options.effects.exposure_change = 0.0;
  options.effects.vignette = 0.5;
  const SyntheticSequence dark = synthesize (options);
  const cv::Mat& exact = easySequence (scene).frames[0].color;
  const auto ratio = [&] (const SyntheticSequence& s, const cv::Rect& part) {
    return meanBrightness (s.frames[0].color (part)) / meanBrightness (exact (part));
  };
  const cv::Rect middle (width / 2 - 5, height / 2 - 5, 10, 10), corner (0, 0, 8, 8);
  EXPECT_NEAR (ratio (dark, middle), 1.0, 0.01);
  EXPECT_NEAR (ratio (dark, corner), 0.53, 0.04);
  EXPECT_GT (std::abs (ratio (changing, middle) - 1.0), 0.01);
  EXPECT_LT (std::abs (ratio (changing, middle) - 1.0), 0.41);
  options.sensor = Sensor::Kinect;
  options.effects.vignette = 0.0;
  EXPECT_NEAR (ratio (synthesize (options), corner), 1.0, 0.02);
}

TEST (CameraEffects, RefusesWhatCannotBe)
{
  SequenceOptions good;
  std::vector<SequenceOptions> bad (6, good);
  bad[0].effects.depth_delay = 1.5;
  bad[1].effects.rolling_shutter = -0.1;
  bad[2].effects.vignette = std::nan ("");
  bad[3].effects.exposure_change = 0.6;
  bad[4].effects.depth_shift_x = 1e9;
  bad[5].effects.distortion.k1 = -5.0;
  for (const SequenceOptions& options : bad) {
    std::string why;
    EXPECT_FALSE (options.isValid (&why));
    EXPECT_FALSE (why.empty());
    EXPECT_THROW (synthesize (options), InvalidInput);
  }
}

TEST (LensDistortion, InverseIsExact)
{
  const LensDistortion lens{0.2624, -0.9531, -0.0054, 0.0026, 1.1633};
  const PinholeCamera camera{517.3, 516.5, 318.6, 255.3};
  EXPECT_TRUE (lens.isValid (camera, 640, 480));
  for (int v = 0; v < 480; v += 40)
    for (int u = 0; u < 640; u += 40) {
      const Eigen::Vector2d ideal = lens.undistortedPixel (camera, u, v);
      const Eigen::Vector2d back = lens.distortedPixel (camera, ideal.x(), ideal.y());
      EXPECT_LT ((back - Eigen::Vector2d (u, v)).norm(), 1e-8);
    }
  std::string why;
  EXPECT_FALSE (
      (LensDistortion{-2.0, 0.0, 0.0, 0.0, 0.0}.isValid (camera, 640, 480, &why)));
  EXPECT_NE (why.find ("k1 -2"), std::string::npos);
}

} // namespace
