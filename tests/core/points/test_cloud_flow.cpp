// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/box_chain.h"
#include <gmock/gmock.h>
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/errors.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

using Points = std::vector<Eigen::Vector3f>;

constexpr int kPoints = 6000;

CloudFlow
estimate (const Points& source, const Points& target, unsigned threads = 2)
{
  SolverParameters solver;
  solver.threads = threads;
  return CloudFlowEstimator (solver).estimate (source, target);
}

/** Mean distance to where the points have gone. */
double
meanError (const CloudFlow& flow, const BoxChain& chain, const ChainCloud& source)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < flow.warped.size(); ++i)
    sum += (flow.warped[i].cast<double>() -
            chain.pose (source.box[i]) * source.rest[i].cast<double>())
               .norm();
  return sum / static_cast<double> (flow.warped.size());
}

double
randIndex (const std::vector<int>& a, const std::vector<int>& b)
{
  double agree = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < a.size(); i += 7)
    for (std::size_t j = 0; j < i; j += 7) {
      agree += (a[i] == a[j]) == (b[i] == b[j]);
      ++all;
    }
  return agree / all;
}

TEST (CloudFlowEstimator, FindsPartsAndJointsOfAChain)
{
  const BoxChain chain;
  const ChainCloud source = drawChain (chain, kPoints, false, 1);
  const ChainCloud target = drawChain (chain, kPoints, true, 2);
  const CloudFlow flow = estimate (source.points, target.points);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  EXPECT_LT (meanError (flow, chain, source), 1e-3);
  EXPECT_GT (randIndex (flow.part, source.box), 0.95);
  ASSERT_EQ (flow.joints.size(), 2u);
  for (const CloudJoint& joint : flow.joints) {
    const int k = joint.point.x() < 1.5 * chain.size.x() ? 1 : 2;
    EXPECT_NEAR (joint.angle, chain.angle, 0.01);
    EXPECT_GT (std::abs (joint.axis.dot (BoxChain::axis (k))), std::cos (0.03));
    EXPECT_LT ((joint.point - chain.seam (k)).cross (joint.axis).norm(), 4e-3);
  }
}

TEST (CloudFlowEstimator, ARigidBodyIsOnePart)
{
  BoxChain chain;
  chain.angle = 0.0;
  const ChainCloud source = drawChain (chain, kPoints, false, 3);
  const ChainCloud target = drawChain (chain, kPoints, true, 4);
  const CloudFlow flow = estimate (source.points, target.points);
  ASSERT_EQ (flow.parts.size(), 1u);
  EXPECT_TRUE (flow.joints.empty());
  EXPECT_LT (meanError (flow, chain, source), 5e-4);
}

TEST (CloudFlowEstimator, BearsDustAndACut)
{
  const BoxChain chain;
  const ChainCloud source = drawChain (chain, kPoints, false, 5);
  ChainCloud target = drawChain (chain, kPoints, true, 6);
  // A quarter is cut off; a tenth more points lie anywhere.
  target.points.erase (
      std::remove_if (target.points.begin(),
                      target.points.end(),
                      [] (const Eigen::Vector3f& p) { return p.x() < 0.2f; }),
      target.points.end());
  std::mt19937 random (7);
  std::uniform_real_distribution<float> place (-0.6f, 1.4f);
  for (int i = 0; i < kPoints / 10; ++i)
    target.points.emplace_back (place (random), place (random), place (random));
  const CloudFlow flow = estimate (source.points, target.points);
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < flow.warped.size(); ++i) {
    const Eigen::Vector3d truth =
        chain.pose (source.box[i]) * source.rest[i].cast<double>();
    if (truth.x() < 0.2)
      continue;
    sum += (flow.warped[i].cast<double>() - truth).norm();
    ++count;
  }
  EXPECT_LT (sum / count, 8e-3);
}

TEST (CloudFlowEstimator, AnyNumberOfThreadsGivesTheSameBits)
{
  const BoxChain chain;
  const ChainCloud source = drawChain (chain, 3000, false, 8);
  const ChainCloud target = drawChain (chain, 3000, true, 9);
  const CloudFlow one = estimate (source.points, target.points, 1);
  const CloudFlow four = estimate (source.points, target.points, 4);
  EXPECT_EQ (std::memcmp (one.warped.data(),
                          four.warped.data(),
                          one.warped.size() * sizeof (Eigen::Vector3f)),
             0);
  EXPECT_EQ (one.part, four.part);
}

TEST (CloudFlowEstimator, TheUnitDoesNotMatter)
{
  const BoxChain chain;
  const ChainCloud source = drawChain (chain, 3000, false, 10);
  const ChainCloud target = drawChain (chain, 3000, true, 11);
  const CloudFlow metres = estimate (source.points, target.points);
  const auto scaled = [] (const Points& points) {
    Points result;
    for (const auto& p : points)
      result.push_back (1024.0f * p); // without rounding
    return result;
  };
  const CloudFlow small = estimate (scaled (source.points), scaled (target.points));
  double sum = 0.0;
  for (std::size_t i = 0; i < metres.warped.size(); ++i)
    sum += (metres.warped[i] - small.warped[i] / 1024.0f).norm();
  EXPECT_LT (sum / static_cast<double> (metres.warped.size()), 1e-4);
}

TEST (CloudFlowEstimator, UnknownPointsStayUnknownAndDoublesGoTogether)
{
  const BoxChain chain;
  ChainCloud source = drawChain (chain, 3000, false, 12);
  const ChainCloud target = drawChain (chain, 3000, true, 13);
  source.points.push_back (Eigen::Vector3f::Constant (NAN));
  source.points.push_back (source.points[0]);
  const CloudFlow flow = estimate (source.points, target.points);
  ASSERT_EQ (flow.warped.size(), 3002u);
  EXPECT_FALSE (flow.warped[3000].allFinite());
  EXPECT_EQ (flow.part[3000], -1);
  EXPECT_EQ (flow.target[3000], -1);
  EXPECT_EQ (flow.warped[3001], flow.warped[0]);
  EXPECT_TRUE (flow.warped[0].allFinite());
}

/** A wavy surface of points and its corner. */
Points
waves (int side, float spacing)
{
  Points points;
  for (int v = 0; v < side; ++v)
    for (int u = 0; u < side; ++u) {
      const Eigen::Vector2f p = spacing * Eigen::Vector2f (u, v);
      points.emplace_back (p.x(),
                           p.y(),
                           2.0F + 0.1F * std::sin (3.0F * p.x()) *
                                      std::cos (2.0F * p.y()));
    }
  return points;
}

TEST (CloudFlowEstimator, ATargetThatIsNearlyNothingIsNoSuccess)
{
  const Points source = waves (40, 0.1F);
  const CloudFlow flow = estimate (source, waves (12, 0.005F));
  EXPECT_FALSE (flow.report.converged);
  EXPECT_EQ (flow.report.stop_reason, StopReason::DifferentPlaces);
  EXPECT_THAT (flow.report.message, ::testing::HasSubstr ("of the source"));
  EXPECT_TRUE (estimate (source, source).report.converged);
}

TEST (CloudFlowEstimator, SaysWhatItCannotTake)
{
  const ChainCloud chain = drawChain (BoxChain(), 3000, false, 14);
  const auto message = [&] (const Points& source, const Points& target) {
    try {
      estimate (source, target);
    }
    catch (const InvalidInput& error) {
      return std::string (error.what());
    }
    return std::string();
  };
  EXPECT_THAT (message ({}, chain.points), HasSubstr ("the source has 0"));
  EXPECT_THAT (message (chain.points, Points (50, Eigen::Vector3f::Ones())),
               HasSubstr ("the target has 1"));
  EXPECT_THAT (message (Points (100, Eigen::Vector3f::Ones()), chain.points),
               HasSubstr ("at one place"));
  Points on_a_map = chain.points;
  for (auto& p : on_a_map)
    p += Eigen::Vector3f (5e5f, 4e6f, 0.0f);
  EXPECT_THAT (message (on_a_map, chain.points), HasSubstr ("subtract an offset"));
}

TEST (CloudFlowEstimator, CanBeCancelled)
{
  const BoxChain chain;
  const ChainCloud source = drawChain (chain, 3000, false, 15);
  SolverParameters solver;
  int calls = 0;
  solver.progress = [&calls] (const Progress&) { return ++calls < 3; };
  const CloudFlow flow =
      CloudFlowEstimator (solver).estimate (source.points, source.points);
  EXPECT_EQ (calls, 3);
  EXPECT_FALSE (flow.report.converged);
  EXPECT_EQ (flow.report.stop_reason, StopReason::Cancelled);
  EXPECT_EQ (flow.warped.size(), source.points.size());
}

} // namespace
