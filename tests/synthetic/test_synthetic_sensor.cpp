// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;

SequenceOptions
roomOptions (Sensor sensor)
{
  SequenceOptions options;
  options.scene = SceneKind::MultiBody;
  options.width = 320;
  options.height = 240;
  options.frames = 4;
  options.supersampling = 2;
  options.sensor = sensor;
  options.seed = 5;
  return options;
}

class WhiteModel : public testing::Test {
protected:
  static void
  SetUpTestSuite ()
  {
    clean_ = synthesize (roomOptions (Sensor::Ideal));
    noisy_ = synthesize (roomOptions (Sensor::White));
  }

  static SyntheticSequence clean_, noisy_;
};

SyntheticSequence WhiteModel::clean_;
SyntheticSequence WhiteModel::noisy_;

TEST_F (WhiteModel, DisparityIsQuantizedWithTheStatedNoise)
{
  double square = 0.0;
  int count = 0;
  for (int v = 0; v < 240; ++v)
    for (int u = 0; u < 320; ++u) {
      const float z = noisy_.frames[0].depth.at<float> (v, u);
      if (std::isnan (z))
        continue;
      const double disparity = 43.5 / z;
      EXPECT_NEAR (8.0 * disparity, std::round (8.0 * disparity), 1e-4);
      const double error = disparity - 43.5 / clean_.frames[0].depth.at<float> (v, u);
      square += error * error;
      ++count;
    }
  // Rounding to 1/8 px adds a variance of (1/8)^2 / 12.
  const double expected = std::sqrt (0.06 * 0.06 + 1.0 / (64.0 * 12.0));
  EXPECT_NEAR (std::sqrt (square / count), expected, 0.03 * expected);
}

TEST_F (WhiteModel, DepthNoiseGrowsWithTheSquareOfDepth)
{
  double square[2] = {0.0, 0.0}, depth[2] = {0.0, 0.0};
  int count[2] = {0, 0};
  for (int v = 0; v < 240; ++v)
    for (int u = 0; u < 320; ++u) {
      const double z = clean_.frames[0].depth.at<float> (v, u);
      const double error = noisy_.frames[0].depth.at<float> (v, u) - z;
      const int far = z > 4.0;
      if (std::isnan (error) || (z > 2.4 && z < 4.0))
        continue;
      square[far] += error * error;
      depth[far] += z;
      ++count[far];
    }
  ASSERT_GT (count[0], 3000);
  ASSERT_GT (count[1], 3000);
  const double ratio = std::sqrt (square[1] / count[1] / (square[0] / count[0]));
  const double depths = depth[1] / count[1] / (depth[0] / count[0]);
  EXPECT_NEAR (ratio, depths * depths, 0.2 * depths * depths);
}

TEST_F (WhiteModel, HolesLieBesideNearerSurfacesAndOnGrazingOnes)
{
  int holes = 0, explained = 0, edges = 0, edge_holes = 0;
  for (int v = 1; v < 239; ++v)
    for (int u = 1; u < 319; ++u) {
      const cv::Mat& clean = clean_.frames[0].depth;
      const double z = clean.at<float> (v, u);
      const bool hole = std::isnan (noisy_.frames[0].depth.at<float> (v, u));
      const double left = clean.at<float> (v, u - 1),
                   right = clean.at<float> (v, u + 1);
      const bool edge = std::abs (43.5 / left - 43.5 / right) > 4.0;
      edges += edge;
      edge_holes += edge && hole;
      if (!hole)
        continue;
      ++holes;
      // The shadow of depth d is as wide as the disparity differs, at half the size.
      double nearest = z;
      for (int x = std::max (0, u - 25); x <= std::min (319, u + 1); ++x)
        for (int y = v - 1; y <= v + 1; ++y)
          nearest = std::min<double> (nearest, clean.at<float> (y, x));
      const double slope = std::abs (clean.at<float> (v - 1, u) - z) / z * 262.4;
      double step = 0.0; // of disparity: a border loses pixels on both of its sides
      for (const double other : {left,
                                 right,
                                 double (clean.at<float> (v - 1, u)),
                                 double (clean.at<float> (v + 1, u))})
        step = std::max (step, std::abs (43.5 / other - 43.5 / z));
      explained += nearest < 0.93 * z || slope > 3.0 || step > 1.4;
    }
  EXPECT_GT (edge_holes, 0.4 * edges);
  EXPECT_GT (holes, 0.02 * 320 * 240);
  EXPECT_LT (holes, 0.25 * 320 * 240);
  EXPECT_GT (explained, 0.97 * holes);
}

TEST_F (WhiteModel, ColourHasNoiseVignetteAndChangingExposure)
{
  double gains[4];
  for (int k = 0; k < 4; ++k) {
    double sum[2] = {0.0, 0.0}, reference[2] = {0.0, 0.0};
    for (int v = 0; v < 240; ++v)
      for (int u = 0; u < 320; ++u) {
        const double r = std::hypot ((u - 159.5) / 159.5, (v - 119.5) / 119.5);
        if (r > 0.3 && r < 1.2)
          continue;
        const cv::Vec3b was = clean_.frames[k].color.at<cv::Vec3b> (v, u);
        sum[r > 1.0] += noisy_.frames[k].color.at<cv::Vec3b> (v, u)[1];
        reference[r > 1.0] += was[1];
      }
    gains[k] = sum[0] / reference[0];
    EXPECT_NEAR (gains[k], 1.0, 0.035);
    EXPECT_LT (sum[1] / reference[1], 0.94 * gains[k]);
  }
  EXPECT_GT (*std::max_element (gains, gains + 4),
             *std::min_element (gains, gains + 4) + 0.005);
}

TEST_F (WhiteModel, ColourNoiseHasTheStatedSize)
{
  // Neighbours' differences of the noise hold no vignette and no exposure.
  double square = 0.0;
  int count = 0;
  for (int v = 80; v < 160; ++v)
    for (int u = 110; u < 210; ++u) {
      const auto noise = [&] (int x) {
        return noisy_.frames[0].color.at<cv::Vec3b> (v, x)[1] -
               static_cast<double> (clean_.frames[0].color.at<cv::Vec3b> (v, x)[1]);
      };
      const double d = noise (u) - noise (u + 1);
      square += 0.5 * d * d;
      ++count;
    }
  EXPECT_NEAR (std::sqrt (square / count), 2.5, 0.3);
}

TEST_F (WhiteModel, TruthStaysExact)
{
  EXPECT_EQ (cv::norm (clean_.truth[1].visible, noisy_.truth[1].visible, cv::NORM_INF),
             0.0);
  EXPECT_EQ (
      cv::norm (clean_.truth[1].scene_flow, noisy_.truth[1].scene_flow, cv::NORM_INF),
      0.0);
}

} // namespace
