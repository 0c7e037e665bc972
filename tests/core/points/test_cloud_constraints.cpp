// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/box_chain.h"
#include "support/cloud_flow_error.h"
#include "support/pose_matcher.h"
#include <gmock/gmock.h>
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/synthetic/body_clouds.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

using Points = std::vector<Eigen::Vector3f>;

SolverParameters
solverOf (bool merge)
{
  SolverParameters solver;
  solver.threads = 2;
  solver.merge_bodies = merge;
  return solver;
}

Points
truthOf (const BoxChain& chain, const ChainCloud& source)
{
  Points truth;
  for (std::size_t i = 0; i < source.rest.size(); ++i)
    truth.push_back (
        (chain.pose (source.box[i]) * source.rest[i].cast<double>()).cast<float>());
  return truth;
}

/** Every so manieth point with truth and the target's point next to where it goes. */
std::vector<KnownPair>
truePairs (const Points& truth, const Points& target, std::size_t step, double weight)
{
  std::vector<KnownPair> pairs;
  for (std::size_t i = 0; i < truth.size(); i += step) {
    const auto nearest = std::min_element (
        target.begin(), target.end(), [&] (const auto& a, const auto& b) {
          return (a - truth[i]).squaredNorm() < (b - truth[i]).squaredNorm();
        });
    pairs.push_back (
        {static_cast<int> (i), static_cast<int> (nearest - target.begin()), weight});
  }
  return pairs;
}

class CloudConstraintsTest : public ::testing::Test {
protected:
  BoxChain chain;
  ChainCloud source = drawChain (chain, 2000, false, 21);
  ChainCloud target = drawChain (chain, 2000, true, 22);
  Points truth = truthOf (chain, source);
};

TEST_F (CloudConstraintsTest, GivenSegmentsAreUsedAsTheyAre)
{
  std::vector<int> labels;
  for (std::size_t i = 0; i < source.box.size(); ++i)
    labels.push_back (i % 50 == 0 ? -3 : 5 * source.box[i] + 2); // with gaps, some none
  const CloudFlow flow = CloudFlowEstimator (solverOf (false))
                             .estimate (source.points, target.points, {}, labels);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  ASSERT_EQ (flow.parts.size(), 3u);
  ASSERT_EQ (flow.segment_part.size(), 3u);
  EXPECT_EQ (flow.touching.size(), 2u);
  EXPECT_EQ (flow.joints.size(), 2u);
  EXPECT_LT (meanError (flow, truth), 1e-3);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ASSERT_EQ (flow.warped[i].allFinite(), labels[i] >= 0);
    ASSERT_EQ (flow.segment[i], labels[i] < 0 ? -1 : source.box[i]);
    ASSERT_EQ (flow.part[i], labels[i] < 0 ? -1 : flow.segment_part[source.box[i]]);
    if (labels[i] < 0)
      continue;
    const RigidPose& pose = flow.parts[flow.part[i]].target_from_source;
    ASSERT_LT (
        (pose * source.points[i].cast<double>() - flow.warped[i].cast<double>()).norm(),
        1e-5);
  }
}

TEST_F (CloudConstraintsTest, GivenSegmentsThatMoveAsOneAreJoinedWhole)
{
  // Each box in two halves, upper and lower.
  std::vector<int> labels;
  for (std::size_t i = 0; i < source.box.size(); ++i)
    labels.push_back (2 * source.box[i] + (source.points[i].z() > 0.0F ? 1 : 0));
  const CloudFlow flow = CloudFlowEstimator (solverOf (true))
                             .estimate (source.points, target.points, {}, labels);
  EXPECT_EQ (flow.parts.size(), 3u);
  ASSERT_EQ (flow.segment_part.size(), 6u);
  for (int box = 0; box < 3; ++box)
    EXPECT_EQ (flow.segment_part[2 * box], flow.segment_part[2 * box + 1]);
  EXPECT_LT (meanError (flow, truth), 1e-3);
}

TEST_F (CloudConstraintsTest, FixedSegmentsDoNotMove)
{
  const CloudFlow flow = CloudFlowEstimator (solverOf (true), {{}, {}, {1}, {}})
                             .estimate (source.points, target.points, {}, source.box);
  for (std::size_t i = 0; i < source.box.size(); ++i) {
    const float step = (flow.warped[i] - source.points[i]).norm();
    ASSERT_TRUE (source.box[i] != 1 || step < 1e-6F) << i << " " << step;
  }
  EXPECT_GT ((flow.warped[0] - source.points[0]).norm(), 1e-2F) << "the others do";
}

TEST_F (CloudConstraintsTest, AFixedSegmentKeepsItsGuess)
{
  CloudConstraints constraints;
  constraints.fixed_segments = {0, 2};
  constraints.guesses = {{0, chain.pose (0)}};
  const RigidPose guess{{0.0, 0.0, 0.1, 0.01, 0.0, 0.0}};
  const CloudFlow flow =
      CloudFlowEstimator (solverOf (false), constraints)
          .estimate (source.points, target.points, guess, source.box);
  for (const auto& [box, pose] : {std::make_pair (0, chain.pose (0)), {2, guess}})
    EXPECT_THAT (flow.parts[flow.segment_part[box]].target_from_source,
                 test::isNear (pose, 1e-9, 1e-9));
}

/** Two like boxes far from each other, and where each one goes. */
struct TwoBoxes {
  BoxChain box;
  Points source;
  Points target;
  Points truth;
  std::vector<int> label;
  std::array<RigidPose, 2> motion;

  TwoBoxes()
  {
    box.boxes = 1;
    box.root = {};
    motion[0] = RigidPose{{0.0, 0.0, 0.1, 0.0, 1.0, 0.0}}; // to the other's place
    motion[1] = RigidPose{{0.0, 0.1, 0.0, 0.0, -1.0, 0.0}};
    for (int b = 0; b < 2; ++b) {
      const Eigen::Vector3f place (0.0F, static_cast<float> (b), 0.0F);
      for (const auto& p : drawChain (box, 1500, false, 23 + b).points) {
        source.push_back (p + place);
        truth.push_back ((motion[b] * source.back().cast<double>()).cast<float>());
        label.push_back (b);
      }
      for (const auto& p : drawChain (box, 1500, false, 25 + b).points)
        target.push_back ((motion[b] * (p + place).cast<double>()).cast<float>());
    }
  }
};

TEST (CloudConstraints, SegmentsBeginWhereTheyAreGuessed)
{
  const TwoBoxes boxes;
  const CloudFlow swapped = CloudFlowEstimator (solverOf (false))
                                .estimate (boxes.source, boxes.target, {}, boxes.label);
  EXPECT_GT (meanError (swapped, boxes.truth), 0.5) << "each stays at its place";
  CloudConstraints constraints;
  for (int b = 0; b < 2; ++b) {
    RigidPose near = boxes.motion[b];
    near.parameters[3] += 0.02;
    constraints.guesses.push_back ({b, near});
  }
  const CloudFlow flow = CloudFlowEstimator (solverOf (false), constraints)
                             .estimate (boxes.source, boxes.target, {}, boxes.label);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  EXPECT_LT (meanError (flow, boxes.truth), 2e-3);
}

TEST (CloudConstraints, PairsTellApartWhatIsAlike)
{
  // A box turned by half a turn, and more: it looks as if it had hardly moved.
  BoxChain box;
  box.boxes = 1;
  box.root = RigidPose{{0.0, 0.0, 3.0, 0.3, 0.02, 0.01}};
  const ChainCloud source = drawChain (box, 1500, false, 31);
  const ChainCloud target = drawChain (box, 1500, true, 32);
  const Points truth = truthOf (box, source);
  const CloudFlow alike =
      CloudFlowEstimator (solverOf (true)).estimate (source.points, target.points);
  EXPECT_GT (meanError (alike, truth), 0.1);
  CloudConstraints constraints;
  constraints.pairs = truePairs (truth, target.points, 350, 1.0); // five
  const CloudFlow flow = CloudFlowEstimator (solverOf (true), constraints)
                             .estimate (source.points, target.points);
  EXPECT_TRUE (flow.report.converged) << flow.report.message;
  EXPECT_LT (meanError (flow, truth), 2e-3);
  EXPECT_EQ (flow.parts.size(), 1u);
}

TEST (CloudConstraints, AFewPairsFindALimbThatWasNotFound)
{
  synthetic::BodyOptions options;
  options.body = synthetic::BodyKind::Chain;
  options.points = 4000;
  options.angle = 100.0;
  options.seed = 4;
  const synthetic::BodyClouds body = synthetic::synthesizeBody (options);
  const CloudFlow lost =
      CloudFlowEstimator (solverOf (true)).estimate (body.source, body.target);
  EXPECT_FALSE (lost.report.converged);
  EXPECT_GT (meanError (lost, body.truth), 0.05);
  CloudConstraints constraints;
  constraints.pairs = truePairs (body.truth, body.target, 350, 1.0); // three a link
  const CloudFlow found = CloudFlowEstimator (solverOf (true), constraints)
                              .estimate (body.source, body.target);
  EXPECT_TRUE (found.report.converged) << found.report.message;
  EXPECT_LT (meanError (found, body.truth), 0.02);
}

TEST_F (CloudConstraintsTest, HardPairsAreKept)
{
  // Not where the target shows the points, 2 cm off it: the middle box alone says so.
  CloudConstraints constraints;
  const Eigen::Vector3f off (0.0F, 0.0F, 0.02F);
  Points more = target.points;
  for (std::size_t i = 0; i < source.box.size(); i += 49)
    if (source.box[i] == 1) {
      constraints.pairs.push_back (
          {static_cast<int> (i), static_cast<int> (more.size()), 1e6});
      more.push_back (truth[i] + off);
    }
  const CloudFlow hard = CloudFlowEstimator (solverOf (false), constraints)
                             .estimate (source.points, more, {}, source.box);
  for (KnownPair& pair : constraints.pairs)
    pair.weight = 0.01;
  const CloudFlow soft = CloudFlowEstimator (solverOf (false), constraints)
                             .estimate (source.points, more, {}, source.box);
  for (const KnownPair& pair : constraints.pairs) {
    EXPECT_LT ((hard.warped[pair.source] - more[pair.target]).norm(), 1e-3F);
    EXPECT_GT ((soft.warped[pair.source] - more[pair.target]).norm(), 1.5e-2F);
  }
}

TEST (CloudConstraints, PointsWithoutWeightOnlyFollow)
{
  BoxChain box;
  box.boxes = 1;
  const ChainCloud source = drawChain (box, 1500, false, 33);
  const ChainCloud target = drawChain (box, 1500, true, 34);
  Points wrong = source.points; // most of them
  Points truth = truthOf (box, source);
  CloudConstraints constraints;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    const bool bad = i % 4 != 0;
    constraints.point_weights.push_back (bad ? 0.0F : 1.0F);
    if (!bad)
      continue;
    wrong[i] += Eigen::Vector3f (0.0F, 0.0F, 0.012F);
    truth[i].setConstant (NAN);
  }
  const CloudFlow misled =
      CloudFlowEstimator (solverOf (true)).estimate (wrong, target.points);
  EXPECT_GT (meanError (misled, truth), 8e-3);
  const CloudFlow flow =
      CloudFlowEstimator (solverOf (true), constraints).estimate (wrong, target.points);
  EXPECT_LT (meanError (flow, truth), 5e-4);
  EXPECT_TRUE (flow.warped[1].allFinite());
}

TEST_F (CloudConstraintsTest, AllOfThemGiveTheSameBitsForAnyNumberOfThreads)
{
  CloudConstraints constraints;
  constraints.pairs = truePairs (truth, target.points, 250, 1.0);
  constraints.point_weights.assign (source.points.size(), 0.5F);
  constraints.fixed_segments = {0};
  constraints.guesses = {{0, chain.pose (0)}};
  SolverParameters solver = solverOf (true);
  const CloudFlow two = CloudFlowEstimator (solver, constraints)
                            .estimate (source.points, target.points, {}, source.box);
  solver.threads = 1;
  const CloudFlow one = CloudFlowEstimator (solver, constraints)
                            .estimate (source.points, target.points, {}, source.box);
  EXPECT_EQ (one.warped, two.warped);
}

TEST_F (CloudConstraintsTest, SaysWhatItCannotTake)
{
  const auto message = [this] (const CloudConstraints& constraints,
                               const std::vector<int>& labels) {
    try {
      CloudFlowEstimator (solverOf (true), constraints)
          .estimate (source.points, target.points, {}, labels);
    }
    catch (const InvalidInput& error) {
      return std::string (error.what());
    }
    return std::string();
  };
  const double nan = std::nan ("");
  EXPECT_THAT (message ({}, {1, 2, 3}), HasSubstr ("3 labels"));
  EXPECT_THAT (message ({}, std::vector<int> (2000, -1)), HasSubstr ("in a segment"));
  EXPECT_THAT (message ({{{2000, 0}}, {}, {}, {}}, {}), HasSubstr ("index 2000"));
  EXPECT_THAT (message ({{{0, 2000}}, {}, {}, {}}, {}), HasSubstr ("the target only"));
  EXPECT_THAT (message ({{{-1, 0}}, {}, {}, {}}, {}), HasSubstr (">= 0"));
  EXPECT_THAT (message ({{{0, 0, nan}}, {}, {}, {}}, {}), HasSubstr ("(0, 1e9]"));
  EXPECT_THAT (message ({{}, {1.0F}, {}, {}}, {}), HasSubstr ("1 weights"));
  EXPECT_THAT (message ({{}, {-1.0F}, {}, {}}, {}), HasSubstr ("[0, 1e6]"));
  EXPECT_THAT (message ({{}, {0.0F}, {}, {}}, {}), HasSubstr ("all be 0"));
  EXPECT_THAT (message ({{}, {}, {0}, {}}, {}), HasSubstr ("segment 0"));
  EXPECT_THAT (message ({{}, {}, {7}, {}}, source.box), HasSubstr ("segment 7"));
  EXPECT_THAT (message ({{}, {}, {-7}, {}}, source.box), HasSubstr ("fixed_segments"));
  EXPECT_THAT (message ({{}, {}, {}, {{0, RigidPose{{nan}}}}}, source.box),
               HasSubstr ("finite"));
}

} // namespace
