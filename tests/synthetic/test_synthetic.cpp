// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/easy_sequences.h"

#include <cmath>
#include <cstring>
#include <ostream>

namespace pcl_msf::synthetic {

void
PrintTo (SceneKind scene, std::ostream* stream)
{
  *stream << toString (scene);
}

} // namespace pcl_msf::synthetic

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;
using namespace pcl_msf::test;

Eigen::Vector3d
pointAt (const SyntheticSequence& sequence, int u, int v)
{
  return sequence.camera.backProject (u, v, sequence.frames[0].depth.at<float> (v, u));
}

/** Calls f (u, v, flow, x, y) for visible pixels that land on (x, y) well inside. */
template <typename F>
void
forEachVisible (const GroundTruth& truth, F&& f)
{
  for (int v = 0; v + 1 < truth.flow.rows; ++v)
    for (int u = 0; u + 1 < truth.flow.cols; ++u) {
      const cv::Vec2f flow = truth.flow.at<cv::Vec2f> (v, u);
      const double x = u + flow[0], y = v + flow[1];
      if (truth.visible.at<unsigned char> (v, u) == 255 && x >= 0 && y >= 0 &&
          x < truth.flow.cols - 1 && y < truth.flow.rows - 1)
        f (u, v, flow, x, y);
    }
}

template <typename T, typename Get>
double
bilinear (const cv::Mat& image, double x, double y, Get&& get)
{
  const int u = static_cast<int> (x), v = static_cast<int> (y);
  const double a = x - u, b = y - v;
  return (1 - b) *
             ((1 - a) * get (image.at<T> (v, u)) + a * get (image.at<T> (v, u + 1))) +
         b * ((1 - a) * get (image.at<T> (v + 1, u)) +
              a * get (image.at<T> (v + 1, u + 1)));
}

/** Mean absolute grey difference between frame 0 and frame 1 along a flow. */
double
photometricResidual (const SyntheticSequence& sequence, double flow_scale)
{
  double sum = 0.0;
  int count = 0;
  forEachVisible (
      sequence.truth[1], [&] (int u, int v, const cv::Vec2f& flow, double, double) {
        const double x = u + flow_scale * flow[0];
        const double y = v + flow_scale * flow[1];
        const cv::Mat& next = sequence.frames[1].color;
        sum += std::abs (bilinear<cv::Vec3b> (next, x, y, gray) -
                         gray (sequence.frames[0].color.at<cv::Vec3b> (v, u)));
        ++count;
      });
  return sum / count;
}

class EveryScene : public testing::TestWithParam<SceneKind> {};

std::string
sceneName (const testing::TestParamInfo<SceneKind>& info)
{
  return toString (info.param);
}

INSTANTIATE_TEST_SUITE_P (Synthetic,
                          EveryScene,
                          testing::ValuesIn (allScenes()),
                          sceneName);

TEST_P (EveryScene, ColourMovesAlongTheTrueFlow)
{
  const SyntheticSequence& sequence = easySequence (GetParam());
  const double along = photometricResidual (sequence, 1.0);
  const bool plain = GetParam() == SceneKind::TexturePoor;
  EXPECT_LT (along, plain ? 1.3 : 5.0);
  EXPECT_GT (photometricResidual (sequence, 0.0), (plain ? 1.3 : 2.0) * along);
}

TEST_P (EveryScene, MotionHasTheWantedSize)
{
  for (const MotionSize motion : {MotionSize::Easy, MotionSize::Large}) {
    const SyntheticSequence sequence =
        motion == MotionSize::Easy ? easySequence (GetParam())
                                   : synthesize (smallOptions (GetParam(), motion));
    double sum[2] = {0.0, 0.0};
    int points[2] = {0, 0}, seen = 0;
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u) {
        const cv::Vec2f flow = sequence.truth[1].flow.at<cv::Vec2f> (v, u);
        seen += sequence.truth[1].visible.at<unsigned char> (v, u) == 255;
        const int moving = sequence.labels.at<int> (v, u) > 0;
        if (std::isfinite (flow[0])) {
          sum[moving] += std::min<float> (width, std::hypot (flow[0], flow[1]));
          ++points[moving];
        }
      }
    const int count = points[0] + points[1];
    const double wanted = (motion == MotionSize::Easy ? 4.0 : 22.0) * width / 640.0;
    const double found =
        std::max ((sum[0] + sum[1]) / count, sum[1] / std::max (1, points[1]));
    EXPECT_NEAR (found, wanted, 0.1 * wanted);
    EXPECT_GT (count, width * height / 2);
    EXPECT_GT (seen, (motion == MotionSize::Easy ? 0.9 : 0.7) * count);
  }
}

TEST_P (EveryScene, FlowIsTheProjectionOfTheMovedPoint)
{
  const SyntheticSequence& sequence = easySequence (GetParam());
  const GroundTruth& truth = sequence.truth[1];
  double largest = 0.0;
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const cv::Vec3f step = truth.scene_flow.at<cv::Vec3f> (v, u);
      const cv::Vec2f flow = truth.flow.at<cv::Vec2f> (v, u);
      if (!std::isfinite (flow[0]))
        continue;
      const Eigen::Vector3d moved =
          pointAt (sequence, u, v) + Eigen::Vector3d (step[0], step[1], step[2]);
      const Eigen::Vector2d uv = sequence.camera.project (moved);
      largest =
          std::max (largest, std::hypot (uv.x() - u - flow[0], uv.y() - v - flow[1]));
    }
  EXPECT_LT (largest, 1e-3);
}

TEST_P (EveryScene, RigidBodiesMoveWithTheirPoses)
{
  const SyntheticSequence& sequence = easySequence (GetParam());
  std::vector<double> largest (sequence.bodies.size(), 0.0);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u) {
      const int label = sequence.labels.at<int> (v, u);
      ASSERT_LT (label, static_cast<int> (sequence.bodies.size()));
      ASSERT_EQ (label < 0, std::isnan (sequence.frames[0].depth.at<float> (v, u)));
      if (label < 0)
        continue;
      const Eigen::Vector3d point = pointAt (sequence, u, v);
      const cv::Vec3f step = sequence.truth[1].scene_flow.at<cv::Vec3f> (v, u);
      const Eigen::Vector3d moved =
          sequence.bodies[label].framek_from_frame0[1] * point - point;
      const Eigen::Vector3d truth (step[0], step[1], step[2]);
      largest[label] =
          std::max (largest[label], (moved - truth).norm() / (1.0 + point.norm()));
    }
  for (std::size_t label = 0; label < largest.size(); ++label) {
    if (sequence.bodies[label].rigid)
      EXPECT_LT (largest[label], 1e-6) << sequence.bodies[label].name;
    else
      EXPECT_GT (largest[label], 1e-3) << sequence.bodies[label].name;
  }
  const RigidPose camera = sequence.frame0_from_framek[1].inverse();
  const RigidPose room = sequence.bodies[0].framek_from_frame0[1];
  EXPECT_LT ((camera.matrix() - room.matrix()).norm(), 1e-6f);
}

/** Relative difference of the four depths around a place; infinite beside NaN. */
double
depthSpread (const cv::Mat& depth, double x, double y)
{
  const int u = static_cast<int> (x), v = static_cast<int> (y);
  double low, high;
  const cv::Mat four = depth (cv::Rect (u, v, 2, 2));
  cv::minMaxLoc (four, &low, &high);
  return cv::checkRange (four) ? (high - low) / low : 1e9;
}

TEST_P (EveryScene, DepthOfTheNextFrameIsThatOfTheMovedPoint)
{
  const SyntheticSequence& sequence = easySequence (GetParam());
  const cv::Mat& next = sequence.frames[1].depth;
  int all = 0, count = 0, bad = 0;
  forEachVisible (
      sequence.truth[1], [&] (int u, int v, const cv::Vec2f&, double x, double y) {
        ++all;
        if (depthSpread (next, x, y) > 0.02)
          return; // a depth edge: interpolation mixes two surfaces
        const auto inverse = [] (float z) { return 1.0 / z; };
        const double there = bilinear<float> (next, x, y, inverse);
        const double z = sequence.frames[0].depth.at<float> (v, u) +
                         sequence.truth[1].scene_flow.at<cv::Vec3f> (v, u)[2];
        ++count;
        bad += !(std::abs (1.0 / there - z) < 5e-3 * z);
      });
  EXPECT_GT (count, 0.5 * all);
  EXPECT_LT (bad, 0.02 * count);
}

TEST_P (EveryScene, ThreadsDoNotChangeTheResult)
{
  SequenceOptions options = smallOptions (GetParam());
  options.sensor = Sensor::Kinect;
  options.width = 128;
  options.height = 96;
  options.threads = 1;
  const SyntheticSequence one = synthesize (options);
  options.threads = 5;
  const SyntheticSequence five = synthesize (options);
  for (int k = 0; k < 2; ++k) {
    EXPECT_TRUE (sameBits (one.frames[k].color, five.frames[k].color));
    EXPECT_TRUE (sameBits (one.frames[k].depth, five.frames[k].depth));
    EXPECT_TRUE (sameBits (one.truth[k].scene_flow, five.truth[k].scene_flow));
    EXPECT_TRUE (sameBits (one.truth[k].visible, five.truth[k].visible));
  }
  options.seed = 4;
  EXPECT_FALSE (sameBits (one.frames[0].color, synthesize (options).frames[0].color));
}

} // namespace
