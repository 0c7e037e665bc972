// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/start/flow_precision.h"
#include <pcl_msf/rgbd_frame.h>

#include <cmath>

namespace {

using namespace pcl_msf;

constexpr int kSide = 128;
constexpr PinholeCamera kCamera{100.0, 100.0, 63.5, 63.5};

/** A wall at 2 m: checks on the left, stripes along y in the middle, bare on the right.
 */
RgbdFrame
wall ()
{
  cv::Mat gray (kSide, kSide, CV_8UC1);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const bool column = x / 16 % 2 == 0;
      const bool row = y / 16 % 2 == 0;
      const bool light = x < 48 ? column != row : x < 96 && column;
      gray.at<unsigned char> (y, x) = light ? 180 : 80;
    }
  return RgbdFrame::fromImages (
      gray, cv::Mat (kSide, kSide, CV_32FC1, cv::Scalar (2.0)), kCamera, {});
}

FlowSample
sampleAt (float u, float v, float du, float dv)
{
  return {(u - 63.5f) / 50.0f, (v - 63.5f) / 50.0f, 2.0f, u + du, v + dv, 0.5f};
}

/** A segment per place, its flow off by (du, dv) from a motion of nothing. */
double
costOf (float u, float v, float du, float dv, float tremble = 0.0f)
{
  FlowHypotheses flow;
  flow.of_segment.resize (1);
  flow.samples.begin = {0, 2};
  flow.samples.samples = {sampleAt (u, v, du + tremble, dv),
                          sampleAt (u, v, du - tremble, dv)};
  flow.of_segment[0].parameters[3] = 2.0 * du / kCamera.fx; // its own fit
  flow.of_segment[0].parameters[4] = 2.0 * dv / kCamera.fy;
  NoiseModel noise{0.005, 0.15, 0.0, 0.003, {20.0, 200.0}};
  return evidenceOfFlow (flow, wall(), kCamera, noise, {}, 1).cost (0, RigidPose());
}

TEST (FlowPrecision, TextureTellsHowWellAPlaceIsKnown)
{
  const double corner = costOf (32, 48, 3, 0);
  EXPECT_GT (corner, 2.0) << "3 px off, 1 px known";
  EXPECT_GT (costOf (32, 48, 0, 3), 2.0);
  EXPECT_GT (costOf (80, 64, 3, 0), 2.0) << "across the stripes";
  EXPECT_LT (costOf (80, 64, 0, 3), 0.05) << "along them";
  EXPECT_LT (costOf (118, 64, 3, 0), 0.05) << "bare";
  EXPECT_LT (costOf (118, 64, 0, 3), 0.05);
}

TEST (FlowPrecision, FlowThatIsNoRigidMotionSaysLess)
{
  EXPECT_LT (costOf (32, 48, 3, 0, 2.0f), 0.6 * costOf (32, 48, 3, 0));
}

} // namespace
