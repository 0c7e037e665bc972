// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/easy_sequences.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::test;

TEST (SyntheticOptions, VisibilityKnowsWhatIsHidden)
{
  // A point is hidden exactly when the next frame's surface at its place is nearer.
  const SyntheticSequence sequence =
      synthesize (smallOptions (SceneKind::MultiBody, MotionSize::Large));
  const GroundTruth& truth = sequence.truth[1];
  int hidden = 0, explained = 0;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const cv::Vec2f flow = truth.flow.at<cv::Vec2f> (v, u);
      const int x = cvRound (u + flow[0]), y = cvRound (v + flow[1]);
      if (x < 1 || y < 1 || x > width - 2 || y > height - 2 ||
          truth.visible.at<unsigned char> (v, u) == 255)
        continue;
      const double z = sequence.frames[0].depth.at<float> (v, u) +
                       truth.scene_flow.at<cv::Vec3f> (v, u)[2];
      double nearest = 1e9;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          nearest = std::min<double> (
              nearest, sequence.frames[1].depth.at<float> (y + dy, x + dx));
      ++hidden;
      explained += nearest < z - 1e-3;
    }
  EXPECT_GT (hidden, 200);
  EXPECT_GT (explained, 0.98 * hidden);
}

TEST (SyntheticOptions, SuccessiveTruthJoinsNeighbours)
{
  SequenceOptions options = smallOptions (SceneKind::Articulated);
  options.frames = 3;
  options.successive_truth = true;
  const SyntheticSequence sequence = synthesize (options);
  ASSERT_EQ (sequence.successive_truth.size(), 2u);
  EXPECT_TRUE (sameBits (sequence.successive_truth[0].flow, sequence.truth[1].flow));
  EXPECT_FALSE (sameBits (sequence.successive_truth[1].flow, sequence.truth[1].flow));
  EXPECT_LT (cv::norm (sequence.truth[0].scene_flow, cv::NORM_INF), 1e-9);
}

TEST (SyntheticOptions, MotionPixelsOverridesTheMotionSize)
{
  SequenceOptions options = smallOptions (SceneKind::MultiBody);
  options.motion_pixels = 2.0;
  const SyntheticSequence slow = synthesize (options);
  options.motion_pixels = 8.0;
  const SyntheticSequence fast = synthesize (options);
  EXPECT_NEAR (fast.frame0_from_framek[1].translation().norm() /
                   slow.frame0_from_framek[1].translation().norm(),
               4.0,
               0.5);
}

TEST (SyntheticOptions, MotionBlurSmearsColourButNotDepth)
{
  SequenceOptions options = smallOptions (SceneKind::StaticRoom, MotionSize::Large);
  const SyntheticSequence sharp = synthesize (options);
  options.motion_blur = true;
  const SyntheticSequence blurred = synthesize (options);
  EXPECT_TRUE (sameBits (sharp.frames[1].depth, blurred.frames[1].depth));
  const auto detail = [] (const cv::Mat& color) {
    double sum = 0.0;
    for (int v = 0; v < color.rows; ++v)
      for (int u = 1; u < color.cols; ++u)
        sum += std::abs (gray (color.at<cv::Vec3b> (v, u)) -
                         gray (color.at<cv::Vec3b> (v, u - 1)));
    return sum;
  };
  EXPECT_LT (detail (blurred.frames[1].color), 0.9 * detail (sharp.frames[1].color));
}

TEST (SyntheticOptions, RefusesOptionsThatCannotBe)
{
  SequenceOptions good;
  EXPECT_TRUE (good.isValid());
  std::vector<SequenceOptions> bad (6, good);
  bad[0].width = 0;
  bad[1].frames = 0;
  bad[2].supersampling = 0;
  bad[3].motion_pixels = std::nan ("");
  bad[4].camera = {-5.0, 5.0, 0.0, 0.0};
  bad[5].height = 100000;
  for (const SequenceOptions& options : bad) {
    std::string why;
    EXPECT_FALSE (options.isValid (&why));
    EXPECT_FALSE (why.empty());
    EXPECT_THROW (synthesize (options), InvalidInput);
  }
  EXPECT_THROW (sceneFromName ("nowhere"), InvalidInput);
  EXPECT_EQ (sceneFromName ("hand"), SceneKind::Hand);
}

} // namespace
