// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/box_chain.h"
#include "support/slid_clouds.h"
#include <gmock/gmock.h>
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/errors.h>

#include <cmath>
#include <cstring>
#include <map>

/* What a window of clouds without a grid promises, whatever moves. */
namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

using Points = std::vector<Eigen::Vector3f>;
using Flows = std::vector<CloudFlow>;

SolverParameters
solverWith (unsigned threads)
{
  SolverParameters solver;
  solver.threads = threads;
  return solver;
}

class CloudWindow : public ::testing::Test {
protected:
  static constexpr int kPoints = 1200;

  CloudWindow() : source (drawChain (bent (1.0), kPoints, false, 1))
  {
    frames.push_back ({source.points, {}});
    for (int t = 1; t <= 2; ++t)
      frames.push_back (
          {drawChain (bent (t), kPoints, true, 1 + static_cast<unsigned> (t)).points,
           {}});
  }
  double
  error (const CloudFlow& flow, double times) const
  {
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i)
      sum += (flow.warped[i].cast<double>() -
              bent (times).pose (source.box[i]) * source.rest[i].cast<double>())
                 .norm();
    return sum / kPoints;
  }

  ChainCloud source;
  std::vector<CloudFrame> frames;
};

/** The estimate of frames as they are drawn, once. */
const Flows&
flowsOf (const std::vector<CloudFrame>& frames, unsigned threads)
{
  static std::map<unsigned, Flows> all;
  Flows& flows = all[threads];
  if (flows.empty())
    flows = CloudFlowEstimator (solverWith (threads)).estimateWindow (frames);
  return flows;
}

bool
sameBits (const Points& a, const Points& b)
{
  return a.size() == b.size() &&
         std::memcmp (a.data(), b.data(), a.size() * sizeof (Eigen::Vector3f)) == 0;
}

TEST_F (CloudWindow, FollowsTheSourceIntoEveryFrame)
{
  const Flows& flows = flowsOf (frames, 4);
  ASSERT_EQ (flows.size(), 3u);
  EXPECT_TRUE (flows[0].warped.empty());
  EXPECT_TRUE (flows[0].report.converged);
  for (int f = 1; f <= 2; ++f) {
    EXPECT_TRUE (flows[f].report.converged) << flows[f].report.message;
    EXPECT_LT (error (flows[f], f), 3e-3) << f;
    ASSERT_EQ (flows[f].parts.size(), flows[1].parts.size());
    ASSERT_GE (flows[f].joints.size(), 1u);
    EXPECT_NEAR (flows[f].joints[0].angle, 0.1 * f, 0.03) << f;
  }
  EXPECT_EQ (flows[1].part, flows[2].part);
}

TEST_F (CloudWindow, OfTwoFramesIsTheEstimateOfTwoClouds)
{
  frames.pop_back();
  const CloudFlowEstimator estimator (solverWith (2));
  const CloudFlow pair = estimator.estimate (frames[0].points, frames[1].points);
  const CloudFlow after = estimator.estimateWindow (frames)[1];
  EXPECT_TRUE (sameBits (pair.warped, after.warped));
  EXPECT_EQ (pair.part, after.part);
  EXPECT_EQ (pair.confidence, after.confidence);
  std::swap (frames[0], frames[1]);
  const CloudFlow before = estimator.estimateWindow (frames, 1)[0];
  EXPECT_TRUE (sameBits (pair.warped, before.warped));
}

TEST_F (CloudWindow, TheReferenceMayStandAmongTheFrames)
{
  // Backwards by a bend, and forwards by another one.
  std::swap (frames[0], frames[1]);
  frames[0].points = drawChain (bent (-1.0), kPoints, true, 7).points;
  frames[1].points = source.points;
  frames[2].points = drawChain (bent (1.0), kPoints, true, 2).points;
  const Flows flows = CloudFlowEstimator (solverWith (2)).estimateWindow (frames, 1);
  EXPECT_LT (error (flows[0], -1.0), 3e-3);
  EXPECT_TRUE (flows[1].warped.empty());
  EXPECT_LT (error (flows[2], 1.0), 3e-3);
  EXPECT_EQ (flows[0].part, flows[2].part);
}

TEST_F (CloudWindow, AnyNumberOfThreadsGivesTheSameBits)
{
  const Flows& one = flowsOf (frames, 1);
  const Flows& four = flowsOf (frames, 4);
  for (int f = 1; f <= 2; ++f)
    EXPECT_TRUE (sameBits (one[f].warped, four[f].warped)) << f;
  EXPECT_EQ (one[2].part, four[2].part);
}

TEST_F (CloudWindow, UnknownPointsStayUnknownInEveryFrame)
{
  frames[0].points[5].x() = NAN;
  frames[1].points[6].y() = INFINITY;
  frames[2].points.resize (kPoints - 200);
  const Flows flows = CloudFlowEstimator (solverWith (2)).estimateWindow (frames);
  for (int f = 1; f <= 2; ++f) {
    ASSERT_EQ (flows[f].warped.size(), source.points.size());
    EXPECT_FALSE (flows[f].warped[5].allFinite());
    EXPECT_EQ (flows[f].part[5], -1);
    EXPECT_TRUE (flows[f].warped[6].allFinite());
  }
}

TEST_F (CloudWindow, GivenSegmentsAreRigidInEveryFrame)
{
  const Flows flows =
      CloudFlowEstimator (solverWith (2)).estimateWindow (frames, 0, {}, source.box);
  for (int f = 1; f <= 2; ++f) {
    EXPECT_LT (error (flows[f], f), 2e-3) << f;
    EXPECT_EQ (flows[f].segment, source.box);
    EXPECT_EQ (flows[f].segment_part.size(), 2u);
  }
}

TEST_F (CloudWindow, FixedSegmentsStayWhereTheyBegin)
{
  CloudConstraints constraints;
  constraints.fixed_segments = {0};
  const RigidPose start{{0.0, 0.0, 0.0, 0.01, 0.0, 0.0}};
  const Flows flows = CloudFlowEstimator (solverWith (2), constraints)
                          .estimateWindow (frames, 0, start, source.box);
  for (int f = 1; f <= 2; ++f)
    for (int i = 0; i < kPoints; i += 100) {
      const float x = (flows[f].warped[i] - source.points[i]).x();
      EXPECT_TRUE (source.box[i] != 0 || std::abs (x - 0.01F) < 1e-6F) << x;
    }
}

TEST_F (CloudWindow, KnownPairsAreOfTheTargetThatTheyName)
{
  const RigidPose far{{0.0, 0.0, 2.0, 1.0, 0.5, 0.0}};
  for (auto& p : frames[2].points)
    p = (far * p.cast<double>()).cast<float>();
  CloudConstraints constraints;
  for (int i = 0; i < kPoints; i += kPoints / 10) {
    const Eigen::Vector3d truth =
        far * (bent (2.0).pose (source.box[i]) * source.rest[i].cast<double>());
    int nearest = 0;
    for (int j = 1; j < kPoints; ++j)
      if ((frames[2].points[j].cast<double>() - truth).norm() <
          (frames[2].points[nearest].cast<double>() - truth).norm())
        nearest = j;
    constraints.pairs.push_back ({i, nearest, 1.0, 1});
  }
  Flows flows =
      CloudFlowEstimator (solverWith (2), constraints).estimateWindow (frames);
  EXPECT_LT (error (flows[1], 1.0), 3e-3);
  for (auto& p : flows[2].warped)
    p = (far.inverse() * p.cast<double>()).cast<float>();
  EXPECT_LT (error (flows[2], 2.0), 3e-3);
}

TEST_F (CloudWindow, TellsWhichFrameWasNotFound)
{
  for (auto& p : frames[1].points)
    p *= 0.1F; // nearly nothing
  const Flows flows = CloudFlowEstimator (solverWith (2)).estimateWindow (frames);
  EXPECT_FALSE (flows[1].report.converged);
  EXPECT_THAT (flows[1].report.message, HasSubstr ("target 1: "));
  EXPECT_FALSE (flows[0].report.converged);
  EXPECT_EQ (flows[0].report.message, flows[1].report.message);
}

TEST_F (CloudWindow, SaysWhatItCannotTake)
{
  const auto message = [] (const std::vector<CloudFrame>& clouds,
                           int reference,
                           const CloudConstraints& constraints = {},
                           double brightness_weight = 1.0) {
    try {
      CloudFlowEstimator (solverWith (1), constraints)
          .estimateWindow (clouds, reference, {}, {}, brightness_weight);
    }
    catch (const InvalidInput& error) {
      return std::string (error.what());
    }
    return std::string();
  };
  EXPECT_THAT (message ({}, 0), HasSubstr ("two clouds or more: there are 0"));
  EXPECT_THAT (message ({frames[0]}, 0), HasSubstr ("there are 1"));
  EXPECT_THAT (message (frames, 3), HasSubstr ("none of the 3"));
  EXPECT_THAT (message (frames, -1), HasSubstr ("none of the 3"));
  EXPECT_THAT (message (frames, 0, {}, NAN), HasSubstr ("brightness"));
  EXPECT_THAT (message (frames, 0, {{{1, 1, 1.0, 2}}, {}, {}, {}}),
               HasSubstr ("target 2"));
  frames[1].normals.resize (kPoints + 1);
  EXPECT_THAT (message (frames, 0),
               HasSubstr ("the target 1 has 1200 points and 1201 normals"));
  frames[1].normals.clear();
  frames[2].points.resize (3);
  EXPECT_THAT (message (frames, 0), HasSubstr ("the target 2 has 3"));
  frames[0].brightness.resize (4);
  frames[1].brightness.resize (5);
  EXPECT_THAT (message (frames, 0), HasSubstr ("brightness"));
  MultiframeParameters multiframe;
  multiframe.concatenation_weight = -1.0;
  EXPECT_THROW (CloudFlowEstimator ({}, {}, multiframe), InvalidInput);
}

TEST_F (CloudWindow, RefusesBrightnessOfAnotherSizeThoughOnlyOneFrameHasSome)
{
  const CloudFlowEstimator estimator (solverWith (1));
  for (const auto& [frame, name] :
       {std::pair (0, "the source has 1200 points and 2 values of brightness"),
        {2, "the target 2 has 1200 points and 2 values of brightness"}}) {
    std::vector<CloudFrame> clouds = frames;
    clouds[frame].brightness = {1.0F, 1.0F};
    try {
      estimator.estimateWindow (clouds);
      ADD_FAILURE() << frame;
    }
    catch (const InvalidInput& error) {
      EXPECT_THAT (error.what(), HasSubstr (name));
      EXPECT_THAT (error.what(), HasSubstr ("give one per point"));
    }
  }
}

TEST_F (CloudWindow, RefusesAStartThatIsNotFiniteBeforeAllElse)
{
  const CloudFlowEstimator estimator (solverWith (1));
  for (const double bad : {double (NAN), double (INFINITY)})
    for (const int parameter : {0, 5}) {
      RigidPose start;
      start.parameters[parameter] = bad;
      try {
        estimator.estimate (frames[0].points, {}, start); // that there is no target
        ADD_FAILURE() << bad;
      }
      catch (const InvalidInput& error) {
        EXPECT_THAT (error.what(), HasSubstr ("the start is not finite: give"));
      }
      EXPECT_THROW (estimator.estimateWindow (frames, 0, start), InvalidInput);
    }
}

TEST_F (CloudWindow, CanBeCancelledAndTellsOfItsStages)
{
  SolverParameters solver = solverWith (2);
  bool window = false;
  double fraction = 0.0;
  std::string stage;
  solver.progress = [&] (const Progress& progress) {
    stage = progress.stage;
    window = window || stage == "window";
    EXPECT_GE (progress.fraction, fraction);
    fraction = progress.fraction;
    return stage != "result"; // too late
  };
  EXPECT_TRUE (CloudFlowEstimator (solver).estimateWindow (frames)[0].report.converged);
  EXPECT_TRUE (window);
  EXPECT_EQ (fraction, 1.0);
  EXPECT_EQ (stage, "result");
  for (const int last : {3, 80}) { // in the first frame's solve, and later
    int calls = 0;
    solver.progress = [&] (const Progress&) { return ++calls < last; };
    const Flows flows = CloudFlowEstimator (solver).estimateWindow (frames);
    EXPECT_EQ (calls, last);
    for (const CloudFlow& flow : flows) {
      EXPECT_FALSE (flow.report.converged);
      EXPECT_EQ (flow.report.stop_reason, StopReason::Cancelled);
    }
    EXPECT_EQ (flows[2].warped.size(), source.points.size());
  }
}

TEST (CloudWindowColors, TellWhatSlidesWithinItsSurface)
{
  const auto first = turnedCylinder (0.15);
  const auto second = turnedCylinder (0.3);
  const std::vector<CloudFrame> frames{{second.source, second.source_brightness},
                                       {first.target, first.target_brightness},
                                       {second.target, second.target_brightness}};
  const CloudFlowEstimator estimator (solverWith (2));
  const Flows with = estimator.estimateWindow (frames);
  const Flows without = estimator.estimateWindow (frames, 0, {}, {}, 0.0);
  EXPECT_LT (second.meanError (with[2].warped),
             0.2 * second.meanError (without[2].warped));
}

} // namespace
