// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/data/body_noise.h"
#include "support/two_bodies.h"

#include <algorithm>

namespace {

using namespace pcl_msf;

constexpr int kTile = 19; // amid the left half

class BodyNoise : public testing::Test {
protected:
  /** The points after sharpening at a state. */
  SegmentPixels
  sharpened (const MotionState& state, int threads = 1)
  {
    DataTerm data = scene_.data();
    data.sweep (state, DataTerm::Pass::Linearize);
    SegmentPixels pixels = scene_.pixels();
    rescaleBodyNoise (
        scene_.terms (data), WindowState (state), tuning_, threads, pixels);
    return pixels;
  }

  /** Factor on a segment's scales; every point of it must have the same. */
  double
  factor (const std::vector<float>& after,
          const std::vector<float>& before,
          int segment) const
  {
    double result = 0.0;
    for (int i = scene_.data().pixels().begin[segment];
         i < scene_.data().pixels().begin[segment + 1];
         ++i) {
      if (!(before[i] > 0.0f))
        continue;
      const double now = after[i] / before[i];
      EXPECT_TRUE (result == 0.0 || std::abs (now - result) < 1e-4 * result);
      result = now;
    }
    return result;
  }

  test::TiledScene scene_{test::foldedWall()};
  BodyNoiseTuning tuning_;
};

TEST_F (BodyNoise, NoiseFreeRigidBodiesAreTrustedMore)
{
  tuning_.most_brightness = 3.0;
  tuning_.most_icp = 10.0;
  const SegmentPixels before = scene_.pixels();
  const SegmentPixels after = sharpened (scene_.solved());
  for (int k = 0; k < before.segments(); ++k) {
    const double brightness =
        factor (after.brightness_scale, before.brightness_scale, k);
    const double icp = factor (after.icp_scale, before.icp_scale, k);
    EXPECT_GT (brightness, 1.2) << k;
    EXPECT_LE (brightness, 1.00001 * tuning_.most_brightness) << k;
    EXPECT_GT (icp, 3.0) << k;
    EXPECT_LE (icp, 1.00001 * tuning_.most_icp) << k;
  }
}

TEST_F (BodyNoise, FewSegmentsProveNothing)
{
  // All but enough tiles with the true motion, but a body of their own.
  tuning_.rigid = 8;
  MotionState state = scene_.solved();
  state.poses.push_back (state.poses[0]);
  int moved = 0;
  for (int& body : state.body_of)
    if (body == 0 && moved < tuning_.rigid - 1) {
      body = 2;
      ++moved;
    }
  ASSERT_EQ (moved, tuning_.rigid - 1);
  const SegmentPixels before = scene_.pixels();
  const SegmentPixels after = sharpened (state);
  for (int k = 0; k < before.segments(); ++k) {
    const double icp = factor (after.icp_scale, before.icp_scale, k);
    if (state.body_of[k] == 2)
      EXPECT_EQ (icp, 1.0) << k;
    else
      EXPECT_GT (icp, 1.0) << k;
  }
}

TEST_F (BodyNoise, BadFitIsNotTrustedLess)
{
  MotionState state = scene_.solved();
  state.poses[0].parameters[3] += 0.05; // metres: several deviations off
  state.poses[0].parameters[5] += 0.10;
  const SegmentPixels before = scene_.pixels();
  const SegmentPixels after = sharpened (state);
  ASSERT_EQ (state.body_of[kTile], 0);
  EXPECT_EQ (factor (after.brightness_scale, before.brightness_scale, kTile), 1.0);
  EXPECT_EQ (factor (after.icp_scale, before.icp_scale, kTile), 1.0);
}

TEST_F (BodyNoise, SameForAnyNumberOfThreads)
{
  const SegmentPixels one = sharpened (scene_.solved(), 1);
  const SegmentPixels three = sharpened (scene_.solved(), 3);
  EXPECT_EQ (one.icp_scale, three.icp_scale);
  EXPECT_EQ (one.brightness_scale, three.brightness_scale);
}

} // namespace
