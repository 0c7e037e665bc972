// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/points/loose_ends.h"
#include "core/points/point_clouds.h"
#include <gmock/gmock.h>
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/synthetic/body_clouds.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::synthetic;

using Points = std::vector<Eigen::Vector3f>;

/** A sheet one wide and as long as asked for, a point every two hundredths. */
Points
sheet (float length)
{
  Points points;
  for (float x = 0.0F; x < length; x += 0.02F)
    for (float y = 0.0F; y < 1.0F; y += 0.02F)
      points.emplace_back (x, y, 0.05F * std::sin (3.0F * x));
  return points;
}

/** Bare pieces of a sheet of two pieces, 2 and 1 long, beyond x = 1.5, that lies on
 * the first one's first part. */
LooseEnds
bareHalves (float length)
{
  Points pieces = sheet (2.0F);
  for (auto p : sheet (1.0F))
    pieces.push_back (p + Eigen::Vector3f (3.0F, 0.0F, 0.0F));
  const Surface surface = makeSurface (pieces, {}, 1);
  const Surface other = makeSurface (sheet (length), {}, 1);
  std::vector<char> covered;
  for (const auto& p : surface.points)
    covered.push_back (p.x() < 1.5F);
  return looseEnds ({surface, surface.points}, covered, {other, other.points}, 1.0);
}

/** \param moved where the source's end is taken to, beyond x = 1.5 */
double
looseEnd (const Points& source, const Eigen::Vector3f& moved)
{
  const PointClouds clouds = preparePointClouds (source, sheet (2.0F), Tuning(), 1);
  const auto beyond = [&clouds] (const Eigen::Vector3f& p) {
    return clouds.asGiven (p).x() > 1.5F;
  };
  Points samples = clouds.source.thin.points;
  for (auto& p : samples)
    if (beyond (p))
      p += moved;
  std::vector<char> covered;
  for (const auto& p : clouds.target.thin.points)
    covered.push_back (!beyond (p));
  const Surface& target = clouds.target.thin;
  return looseEnds (
             {target, target.points}, covered, {clouds.source.thin, samples}, 1.0)
      .largest;
}

TEST (LooseEnds, AreWhatTheSourceLeavesBareThoughItGoesOn)
{
  EXPECT_NEAR (looseEnd (sheet (2.0F), {0.0F, 0.0F, 0.3F}), 0.25, 0.02);
  EXPECT_EQ (looseEnd (sheet (1.5F), {0.0F, 0.0F, 0.0F}), 0.0) << "it is cut off there";
}

TEST (LooseEnds, CountWholePiecesOnlyAmongAll)
{
  EXPECT_NEAR (bareHalves (2.0F).largest, 0.5 / 3.0, 0.02);
  EXPECT_NEAR (bareHalves (2.0F).all, 1.5 / 3.0, 0.02);
  EXPECT_EQ (bareHalves (1.5F).largest, 0.0) << "cut off there";
  EXPECT_NEAR (bareHalves (1.5F).all, 1.0 / 3.0, 0.02);
}

TEST (LooseEnds, GapsAreWhereSegmentsPart)
{
  SurfaceSegments segments;
  segments.radius = 0.5;
  segments.links = {{0, 1, Eigen::Vector3d (1.0, 0.0, 0.0), 0.3},
                    {1, 2, Eigen::Vector3d (2.0, 0.0, 0.0), 0.3}};
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd (1.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d joint = segments.links[0].midpoint;
  const RigidPose hinge = RigidPose::fromMatrix (turn, joint - turn * joint);
  EXPECT_NEAR (meanGap (segments, {{}, hinge, hinge}), 0.0, 1e-12) << "a joint";
  RigidPose away = hinge;
  away.parameters[4] += 0.2;
  EXPECT_NEAR (meanGap (segments, {{}, hinge, away}), 0.2, 1e-12);
}

/** Share of a flat sheet, two long, that lies on itself when its second half is moved.
 */
double
overlapOfHalf (const Eigen::Matrix3f& turn, const Eigen::Vector3f& shift)
{
  Points flat = sheet (2.0F);
  for (auto& p : flat)
    p.z() = 0.0F;
  const Surface surface = makeSurface (flat, {}, 1);
  MovedPoints moved{surface.points, surface.normals, {}};
  for (int i = 0; i < surface.size(); ++i)
    if (surface.points[i].x() > 1.0F) {
      moved.points[i] = turn * surface.points[i] + shift;
      moved.normals[i] = turn * surface.normals[i];
    }
  return selfOverlap (surface, moved, {}, 2);
}

TEST (LooseEnds, ASurfaceThatLiesOnItselfOverlaps)
{
  const Eigen::Matrix3f none = Eigen::Matrix3f::Identity();
  EXPECT_EQ (overlapOfHalf (none, {0.0F, 0.0F, 0.0F}), 0.0);
  EXPECT_NEAR (overlapOfHalf (none, {-1.0F, 0.0F, 0.0F}), 1.0, 0.02);
  EXPECT_NEAR (overlapOfHalf (none, {-0.5F, 0.0F, 0.0F}), 0.5, 0.1);
  EXPECT_EQ (overlapOfHalf (none, {0.5F, 0.0F, 0.0F}), 0.0) << "torn";
}

TEST (LooseEnds, WhatTouchesFaceToFaceDoesNotOverlap)
{
  // Folded back about the middle, as a book that is closed.
  Eigen::Matrix3f fold = Eigen::Matrix3f::Identity();
  fold (0, 0) = fold (2, 2) = -1.0F;
  EXPECT_EQ (overlapOfHalf (fold, {2.0F, 0.0F, 0.01F}), 0.0);
}

TEST (LooseEnds, StretchIsTheRatioOfLengths)
{
  const PointClouds clouds = preparePointClouds (sheet (1.0F), sheet (1.0F), {}, 1);
  const Surface& surface = clouds.source.surface;
  Points moved = surface.points;
  for (float s : stretchOf (surface, moved, 2))
    EXPECT_EQ (s, 0.0F);
  for (auto& p : moved)
    p *= 1.5F;
  for (float s : stretchOf (surface, moved, 2))
    EXPECT_NEAR (s, 0.5F, 1e-3F);
  for (auto& p : moved)
    p /= 3.0F;
  for (float s : stretchOf (surface, moved, 2))
    EXPECT_NEAR (s, 1.0F, 1e-3F);
}

class Bodies : public ::testing::Test {
protected:
  void
  draw (BodyKind body, double angle, double cut = 0.0)
  {
    BodyOptions options;
    options.body = body;
    options.angle = angle;
    options.cut = cut;
    options.noise = 1e-3;
    options.points = 5000;
    clouds_ = synthesizeBody (options);
  }
  /** Turns the target about its middle. */
  void
  turn (const Eigen::Vector3f& axis, float degrees)
  {
    const auto& target = clouds_.target;
    const Eigen::Vector3f center =
        std::accumulate (target.begin(), target.end(), Eigen::Vector3f (0, 0, 0)) /
        static_cast<float> (target.size());
    const Eigen::AngleAxisf rotation (degrees * static_cast<float> (M_PI) / 180.0F,
                                      axis);
    for (Points* points : {&clouds_.target, &clouds_.truth})
      for (auto& p : *points)
        p = center + rotation * (p - center);
  }
  CloudFlow
  estimate ()
  {
    SolverParameters solver;
    solver.threads = 2;
    CloudFlow flow =
        CloudFlowEstimator (solver).estimate (clouds_.source, clouds_.target);
    errors_.clear();
    for (std::size_t i = 0; i < flow.warped.size(); ++i)
      errors_.push_back ((flow.warped[i] - clouds_.truth[i]).norm());
    return flow;
  }
  /** Share of the points with truth that are farther from it. */
  double
  wrong (float distance) const
  {
    double count = 0.0;
    double all = 0.0;
    for (const float e : errors_)
      if (std::isfinite (e)) {
        count += e > distance;
        ++all;
      }
    return count / all;
  }

  BodyClouds clouds_;
  std::vector<float> errors_;
};

TEST_F (Bodies, AreFoundFromAStartThatIsNearEnough)
{
  draw (BodyKind::Animal, 25.0);
  turn (Eigen::Vector3f::UnitX(), 40.0F);
  const CloudFlow flow = estimate();
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  EXPECT_LT (wrong (0.05F), 0.01);
  EXPECT_LT (flow.loose_target, 0.01);
  EXPECT_LT (flow.gap, 0.15);
}

TEST_F (Bodies, WithLegsOnOtherLegsAreNotFound)
{
  draw (BodyKind::Animal, 25.0);
  turn (Eigen::Vector3f::UnitX(), 180.0F);
  const CloudFlow flow = estimate();
  ASSERT_GT (wrong (0.1F), 0.3);
  EXPECT_FALSE (flow.report.converged);
  EXPECT_EQ (flow.report.stop_reason, StopReason::DifferentPlaces);
  EXPECT_GT (flow.loose_target, 0.03);
}

TEST_F (Bodies, ThatAreTwistedAreNotFound)
{
  draw (BodyKind::Chain, 25.0);
  turn (Eigen::Vector3f::UnitX(), 75.0F);
  const CloudFlow flow = estimate();
  ASSERT_GT (wrong (0.05F), 0.3);
  EXPECT_FALSE (flow.report.converged);
  EXPECT_THAT (flow.report.message, ::testing::HasSubstr ("torn or twisted"));
}

TEST_F (Bodies, AreFoundThoughBothAreCutOff)
{
  draw (BodyKind::Animal, 25.0);
  // The source has no head and front legs, the target no tail and hind legs.
  const auto keep = [] (Points& points, bool (*out) (float)) {
    points.erase (std::remove_if (points.begin(),
                                  points.end(),
                                  [out] (const auto& p) { return out (p.x()); }),
                  points.end());
  };
  keep (clouds_.source, [] (float x) { return x > 0.25F; });
  keep (clouds_.target, [] (float x) { return x < -0.25F; });
  const CloudFlow flow = CloudFlowEstimator().estimate (clouds_.source, clouds_.target);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  EXPECT_LT (flow.explained_source, 0.98);
  EXPECT_LT (flow.explained_target, 0.98);
  EXPECT_LT (flow.unexplained, 0.02);
}

TEST_F (Bodies, ThatAreCutOffAreFoundAndConfidenceSortsTheirErrors)
{
  draw (BodyKind::Animal, 45.0, 0.25);
  const CloudFlow flow = estimate();
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  std::vector<std::pair<float, float>> sorted; // confidence, error
  for (std::size_t i = 0; i < errors_.size(); ++i)
    if (std::isfinite (errors_[i]))
      sorted.emplace_back (flow.confidence[i], errors_[i]);
  std::sort (sorted.begin(), sorted.end());
  const auto mean = [&sorted] (std::size_t from, std::size_t to) {
    double sum = 0.0;
    for (std::size_t i = from; i < to; ++i)
      sum += sorted[i].second;
    return sum / static_cast<double> (to - from);
  };
  const std::size_t n = sorted.size();
  EXPECT_GT (mean (0, n / 5), 2.0 * mean (n - n / 5, n));
}

} // namespace
