// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/points/point_result.h"
#include "support/box_chain.h"
#include <gmock/gmock.h>
#include <pcl_msf/cloud_flow_estimator.h>

#include <cmath>
#include <random>

/* Clouds as scanners leave them: strays, noise that hides the shape, segments that lie
 * among each other. */
namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

using Points = std::vector<Eigen::Vector3f>;

constexpr int kPoints = 2000;

CloudFlow
estimate (const Points& source,
          const Points& target,
          const std::vector<int>& segments = {})
{
  SolverParameters solver;
  solver.threads = 2;
  return CloudFlowEstimator (solver).estimate (source, target, {}, segments);
}

class StrayPoint : public ::testing::TestWithParam<float> {};

TEST_P (StrayPoint, DoesNotSetTheScale)
{
  BoxChain chain;
  chain.boxes = 2;
  ChainCloud source = drawChain (chain, kPoints, false, 1);
  const Points target = drawChain (chain, kPoints, true, 2).points;
  source.points[7].x() = GetParam();
  const CloudFlow flow = estimate (source.points, target);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i)
    if (i != 7)
      sum += (flow.warped[i].cast<double>() -
              chain.pose (source.box[i]) * source.rest[i].cast<double>())
                 .norm();
  EXPECT_LT (sum / kPoints, 4e-3);
}

INSTANTIATE_TEST_SUITE_P (Far, StrayPoint, ::testing::Values (40.0F, -1000.0F, 1e30F));

/** A room's corner of three walls, 3 m wide, as a camera sees it. */
Points
corner (int count, double noise, const Eigen::Isometry3d& motion, unsigned seed)
{
  std::mt19937 random (seed);
  std::uniform_real_distribution<double> along (0.0, 3.0);
  std::normal_distribution<double> off (0.0, noise);
  Points points;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    p[(i + 1) % 3] = along (random);
    p[(i + 2) % 3] = along (random);
    p = motion * (p + Eigen::Vector3d (-1.5, -1.5, 3.0));
    for (int axis = 0; axis < 3; ++axis)
      p[axis] += off (random);
    points.push_back (p.cast<float>());
  }
  return points;
}

TEST (NoisyRoom, MovesAsOneWhenPartsExplainNothingMore)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate (Eigen::AngleAxisd (0.026, Eigen::Vector3d::UnitZ()));
  motion.pretranslate (Eigen::Vector3d (0.03, 0.02, 0.02));
  const Points source = corner (3000, 0.1, Eigen::Isometry3d::Identity(), 1);
  const CloudFlow flow = estimate (source, corner (3000, 0.1, motion, 2));
  EXPECT_EQ (flow.parts.size(), 1u);
  double sum = 0.0;
  int known = 0;
  for (std::size_t i = 0; i < source.size(); ++i)
    if (flow.warped[i].allFinite()) {
      sum += (flow.warped[i].cast<double>() - motion * source[i].cast<double>()).norm();
      ++known;
    }
  ASSERT_GT (known, 2900);
  EXPECT_LT (sum / known, 0.06); // two thirds of the noise; of parts it is all of it
}

TEST (NoisyRoom, IsNotFoundWhereMostPointsLieOffEachOther)
{
  const SolveProgress progress ({}, 10);
  CloudFlow flow;
  flow.explained_source = flow.explained_target = 1.0;
  noteOutcome (progress, 0.3, {}, flow);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  noteOutcome (progress, 0.6, {}, flow);
  EXPECT_FALSE (flow.report.converged);
  EXPECT_EQ (flow.report.stop_reason, StopReason::DifferentPlaces);
  EXPECT_THAT (flow.report.message, HasSubstr ("60.0 % of both clouds"));
}

TEST (MixedSegments, AreSolvedAsOthersAre)
{
  BoxChain chain;
  chain.boxes = 1;
  const ChainCloud source = drawChain (chain, kPoints, false, 1);
  std::vector<int> segments;
  for (int i = 0; i < kPoints; ++i)
    segments.push_back (i * 7919 % 60); // each all over the body
  const CloudFlow flow =
      estimate (source.points, drawChain (chain, kPoints, true, 2).points, segments);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  double sum = 0.0;
  for (int i = 0; i < kPoints; ++i)
    sum +=
        (flow.warped[i].cast<double>() - chain.pose (0) * source.rest[i].cast<double>())
            .norm();
  EXPECT_LT (sum / kPoints, 2e-3);
}

} // namespace
