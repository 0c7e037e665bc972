// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/points/point_matching.h"
#include "support/slid_clouds.h"
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/errors.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace pcl_msf;
using pcl_msf::testing::SlidClouds;
using pcl_msf::testing::slidWall;
using pcl_msf::testing::turnedCylinder;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

double
valueOf (const PointPull& pull, const Eigen::Vector3d& x)
{
  return 0.5 * x.dot (pull.a * x) - pull.b.dot (x) + pull.c;
}

TEST (PointPull, TakesAPointToWhereItIsAsBright)
{
  const Eigen::Vector3d q (0.3, -0.2, 0.8);
  const Eigen::Vector3d slope (2.0, -1.0, 0.5);
  const Eigen::Vector3d x (0.5, 0.1, 0.4);
  PointPull pull;
  pull.addSlope (q, slope, 0.7, 3.0);
  // d = (0.2, 0.3, -0.4): slope'd = 0.4 - 0.3 - 0.2 = -0.1
  EXPECT_NEAR (valueOf (pull, x), 0.5 * 3.0 * 0.6 * 0.6, 1e-12);
  EXPECT_EQ (pull.weight, 0.0);
  const Eigen::Vector3d gradient = pull.a * x - pull.b;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d h = 1e-5 * Eigen::Vector3d::Unit (k);
    EXPECT_NEAR (
        gradient[k], (valueOf (pull, x + h) - valueOf (pull, x - h)) / 2e-5, 1e-8);
  }
}

/** A square of points in the plane z = 0, facing up. */
Surface
square ()
{
  Surface surface;
  for (int i = 0; i < 900; ++i) {
    surface.points.emplace_back (0.01f * (i % 30), 0.01f * (i / 30), 0.0f);
    surface.normals.emplace_back (Eigen::Vector3f::UnitZ());
  }
  return surface;
}

TEST (SurfaceTexture, HasTheSlopeOfThePattern)
{
  const Surface surface = square();
  std::vector<float> brightness;
  for (const auto& p : surface.points)
    brightness.push_back (3.0f * p.x() - 4.0f * p.y() + 0.2f);
  brightness[40] = kNone;
  const SurfaceTexture texture = fitTexture (surface, brightness, 0.025, 48, 1);
  EXPECT_NEAR (texture.slope, 5.0, 1e-3);
  EXPECT_NEAR (texture.trust, 1.0, 1e-3);
  EXPECT_NEAR (texture.value[40], 3.0f * 0.1f - 4.0f * 0.01f + 0.2f, 1e-4);
  EXPECT_NEAR ((texture.gradient[455] - Eigen::Vector3f (3.0f, -4.0f, 0.0f)).norm(),
               0.0f,
               1e-3f);
}

TEST (SurfaceTexture, NoiseAndOneColourAreNone)
{
  const Surface surface = square();
  EXPECT_FALSE (
      fitTexture (surface, std::vector<float> (900, 0.7f), 0.025, 48, 1).varies());
  EXPECT_FALSE (
      fitTexture (surface, std::vector<float> (900, kNone), 0.025, 48, 1).varies());
  std::mt19937 random (1);
  std::vector<float> noise;
  for (int i = 0; i < 900; ++i)
    noise.push_back (static_cast<float> (random() / 4294967296.0));
  EXPECT_LT (fitTexture (surface, noise, 0.025, 48, 1).trust, 0.3);
}

TEST (BrightnessComparison, ADifferenceIsADistanceUnderAnyExposure)
{
  const Surface surface = square();
  std::vector<float> brightness;
  MovedPoints moved{surface.points, surface.normals, {}};
  std::vector<PointPair> matches;
  for (int i = 0; i < 900; ++i) {
    const Eigen::Vector3f& p = surface.points[i];
    brightness.push_back (3.0f * p.x() - 4.0f * p.y());
    moved.brightness.push_back (2.0f * brightness[i] + 0.3f); // another exposure
    matches.push_back ({i, i, 1.0});
  }
  const SurfaceTexture texture = fitTexture (surface, brightness, 0.025, 48, 1);
  const BrightnessComparison compared (
      moved, matches, surface, texture, 0.01, 1.0, 2.5);
  ASSERT_TRUE (compared.used());
  EXPECT_NEAR (compared.gain(), 0.5, 1e-4);
  EXPECT_NEAR (compared.offset(), -0.15, 1e-4);
  EXPECT_NEAR (compared.correlation(), 1.0, 1e-4);
  EXPECT_NEAR (compared.difference (moved, 455, 455), 0.0, 1e-4);
  // The point two rows on is darker by 4 * 0.02, which is 0.016 at a slope of 5.
  EXPECT_NEAR (compared.difference (moved, 455 + 60, 455), 0.0, 1e-4);
  MovedPoints wrong = moved;
  wrong.points[455 + 60] = surface.points[455];
  EXPECT_NEAR (compared.difference (wrong, 455 + 60, 455), 0.016, 1e-4);
}

CloudFlow
registered (const SlidClouds& clouds, bool bright, unsigned threads = 1)
{
  SolverParameters solver;
  solver.threads = threads;
  CloudBrightness brightness;
  if (bright) {
    brightness.source = clouds.source_brightness;
    brightness.target = clouds.target_brightness;
  }
  return CloudFlowEstimator (solver).estimate (
      clouds.source, clouds.target, {}, {}, brightness);
}

TEST (CloudBrightness, FindsTheTurnOfACylinderAboutItsAxis)
{
  SlidClouds clouds = turnedCylinder (0.35);
  EXPECT_GT (clouds.meanError (registered (clouds, false).warped), 0.03);
  for (float& b : clouds.target_brightness)
    b = 300.0f * b - 40.0f; // another exposure
  const CloudFlow flow = registered (clouds, true);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  EXPECT_LT (clouds.meanError (flow.warped), 2e-3);
  EXPECT_EQ (flow.parts.size(), 1u);
  EXPECT_EQ (registered (clouds, true, 3).warped, flow.warped);
}

TEST (CloudBrightness, FindsTheJointOfACylinderThatIsTwisted)
{
  const SlidClouds clouds = turnedCylinder (0.35, 0.5);
  const CloudFlow shape = registered (clouds, false);
  EXPECT_GT (clouds.meanError (shape.warped), 0.01);
  const CloudFlow flow = registered (clouds, true);
  EXPECT_LT (clouds.meanError (flow.warped), 4e-3);
  ASSERT_GE (flow.joints.size(), 1u);
  EXPECT_NEAR (flow.joints[0].angle, 0.35, 0.02);
  EXPECT_GT (std::abs (flow.joints[0].axis.x()), 0.99);
}

TEST (CloudBrightness, FindsAWallThatSlidesBehindItsWindow)
{
  const SlidClouds clouds = slidWall (0.05);
  EXPECT_GT (clouds.meanError (registered (clouds, false).warped), 0.04);
  const CloudFlow flow = registered (clouds, true);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  EXPECT_LT (clouds.meanError (flow.warped), 2e-3);
}

/** What shape alone makes of a small turn, once. */
const CloudFlow&
shapeOfASmallTurn ()
{
  static const CloudFlow flow = registered (turnedCylinder (0.1), false);
  return flow;
}

TEST (CloudBrightness, WithoutAnyTheBitsAreThoseOfShape)
{
  SlidClouds clouds = turnedCylinder (0.1);
  const CloudFlow& shape = shapeOfASmallTurn();
  const std::vector<float> pattern = clouds.source_brightness;
  clouds.source_brightness.assign (pattern.size(), 0.4f); // one colour
  EXPECT_EQ (registered (clouds, true).warped, shape.warped);
  clouds.source_brightness.assign (pattern.size(), kNone);
  EXPECT_EQ (registered (clouds, true).warped, shape.warped);
}

TEST (CloudBrightness, ColoursOfSomethingElseAreDropped)
{
  SlidClouds clouds = turnedCylinder (0.1);
  const CloudFlow& shape = shapeOfASmallTurn();
  std::mt19937 random (3);
  for (float& b : clouds.source_brightness)
    b = static_cast<float> (random() / 4294967296.0);
  EXPECT_EQ (registered (clouds, true).warped, shape.warped);
}

TEST (CloudBrightness, SaysWhatItCannotTake)
{
  SlidClouds clouds = turnedCylinder (0.1);
  clouds.target_brightness.pop_back();
  try {
    registered (clouds, true);
    FAIL();
  }
  catch (const InvalidInput& error) {
    EXPECT_NE (std::string (error.what()).find ("target has 2000 points and 1999"),
               std::string::npos)
        << error.what();
  }
  CloudBrightness brightness;
  brightness.weight = -1.0;
  EXPECT_THROW (
      CloudFlowEstimator().estimate (clouds.source, clouds.target, {}, {}, brightness),
      InvalidInput);
}

} // namespace
