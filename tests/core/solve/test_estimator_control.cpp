// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/room.h"
#include <gmock/gmock.h>
#include <pcl_msf/errors.h>

#include <cmath>
#include <cstring>
#include <functional>

namespace {

using namespace pcl_msf;
using testing::HasSubstr;
using Room = test::Room;

bool
sameBytes (const cv::Mat& a, const cv::Mat& b)
{
  return a.size() == b.size() && a.type() == b.type() && a.isContinuous() &&
         b.isContinuous() &&
         std::memcmp (a.data, b.data, a.total() * a.elemSize()) == 0;
}

TEST_F (Room, SameBytesForAnyNumberOfThreadsAndEveryTime)
{
  SolverParameters solver = alone();
  solver.threads = 1;
  const SceneFlow first = estimate (solver);
  for (const unsigned threads : {1u, 2u, 5u}) {
    solver.threads = threads;
    const SceneFlow other = estimate (solver);
    EXPECT_TRUE (sameBytes (first.flow, other.flow)) << threads;
    EXPECT_TRUE (sameBytes (first.displacement, other.displacement)) << threads;
    EXPECT_TRUE (sameBytes (first.visibility, other.visibility)) << threads;
    EXPECT_EQ (first.report.final_cost.total(), other.report.final_cost.total());
    ASSERT_EQ (first.segments.size(), other.segments.size());
    for (std::size_t k = 0; k < first.segments.size(); ++k) {
      EXPECT_EQ (first.segments[k].information, other.segments[k].information);
      EXPECT_EQ (first.segments[k].group, other.segments[k].group);
    }
  }
}

TEST_F (Room, ReportTellsTheTruth)
{
  const SceneFlow result = estimate();
  const Report& report = result.report;
  EXPECT_TRUE (report.stop_reason == StopReason::Converged ||
               report.stop_reason == StopReason::IterationLimit);
  EXPECT_TRUE (report.converged);
  EXPECT_EQ (report.message, "");
  EXPECT_GT (report.iterations, 0);
  EXPECT_EQ (report.history.size(), static_cast<std::size_t> (report.iterations));
  // A step's cost is taken before correspondences are renewed, its terms after.
  for (const IterationRecord& record : report.history)
    EXPECT_NEAR (record.terms.total(), record.cost, 0.1 * record.cost);
  // A level has an energy of its own, and its number.
  EXPECT_EQ (report.history.front().energy, 0);
  for (std::size_t i = 1; i < report.history.size(); ++i) {
    const int step = report.history[i].energy - report.history[i - 1].energy;
    EXPECT_GE (step, report.history[i].level != report.history[i - 1].level ? 1 : 0);
  }
  EXPECT_LE (report.final_cost.total(), report.initial_cost.total());
  EXPECT_EQ (result.segments.size(), static_cast<std::size_t> (segments_.size()));
  for (const SegmentMotion& segment : result.segments)
    EXPECT_TRUE (segment.current_from_reference.isFinite());
  for (const SegmentPair& pair : result.pairs) {
    EXPECT_LT (pair.first, pair.second);
    EXPECT_GE (pair.weight, 0.0);
    EXPECT_LE (pair.weight, 1.0 + 1e-9);
  }
}

TEST_F (Room, GuessIsAStart)
{
  // Half a metre to the side, and no optical flow to suggest it.
  test::AnalyticScene far = scene_;
  far.motions.assign (2, test::turnAbout ({0, 0, 2.5}, {0.0, 0.02, 0.0}, {0.5, 0, 0}));
  const RgbdFrame current = far.frame (far.render (true));
  SolverParameters solver = alone();
  solver.flow_proposals = false;
  RigidPose guess = far.motions[0];
  guess.parameters[3] += 0.02;
  const auto off = [&] (const RigidPose& start) {
    const RigidPose found = SceneFlowEstimator ({}, solver)
                                .estimate (reference_, current, segments_, start)
                                .dominant_motion;
    const Eigen::Vector3d p (0.0, 0.0, 2.5);
    return (found * p - far.motions[0] * p).norm();
  };
  EXPECT_LT (off (guess), 0.005);
  // Without descent, what comes out is what went in.
  solver.max_iterations = 0;
  solver.merge_bodies = false;
  EXPECT_NEAR (off (guess), 0.02, 1e-6);
  EXPECT_NEAR (off ({}), 0.5, 1e-6);
}

TEST_F (Room, ProgressCanCancelAndTheResultIsUsable)
{
  int calls = 0;
  double last = 0.0;
  SolverParameters solver = alone();
  solver.progress = [&] (const Progress& p) {
    EXPECT_GE (p.fraction, last);
    EXPECT_LE (p.fraction, 1.0);
    EXPECT_EQ (p.iteration, calls + 1);
    last = p.fraction;
    return ++calls < 3;
  };
  const SceneFlow result = estimate (solver);
  EXPECT_EQ (calls, 3);
  EXPECT_EQ (result.report.stop_reason, StopReason::Cancelled);
  EXPECT_FALSE (result.report.converged);
  EXPECT_EQ (result.flow.size(), view_.depth.size());
  const auto all = errors (result);
  EXPECT_LT (all[all.size() / 2], 1.0); // the start is good already
}

TEST_F (Room, ProgressIsMonotonicToTheEnd)
{
  double last = 0.0;
  std::string stage;
  SolverParameters solver = alone();
  solver.progress = [&] (const Progress& p) {
    EXPECT_GE (p.fraction, last);
    EXPECT_LE (p.fraction, 1.0);
    EXPECT_STRNE (p.stage, "");
    last = p.fraction;
    stage = p.stage;
    return stage != "result"; // too late
  };
  const SceneFlow result = estimate (solver);
  EXPECT_EQ (last, 1.0);
  EXPECT_EQ (stage, "result");
  EXPECT_TRUE (result.report.converged);
}

TEST_F (Room, TimeBudgetIsKept)
{
  SolverParameters solver = alone();
  solver.max_seconds = 1e-6;
  const SceneFlow result = estimate (solver);
  EXPECT_EQ (result.report.stop_reason, StopReason::TimeLimit);
  EXPECT_FALSE (result.report.converged);
  EXPECT_EQ (result.report.iterations, 0);
  EXPECT_EQ (result.flow.size(), view_.depth.size());
  solver.max_seconds = 1000.0;
  EXPECT_NE (estimate (solver).report.stop_reason, StopReason::TimeLimit);
}

TEST_F (Room, NoIterationsStillGiveAResult)
{
  SolverParameters solver = alone();
  solver.max_iterations = 0;
  const SceneFlow result = estimate (solver);
  EXPECT_EQ (result.report.iterations, 0);
  EXPECT_EQ (result.report.stop_reason, StopReason::IterationLimit);
  EXPECT_TRUE (result.report.converged); // an ordinary end, as PCL's ICP has it
  EXPECT_EQ (result.flow.size(), view_.depth.size());
}

TEST_F (Room, RefusesBadInputAndSaysWhy)
{
  const auto refused = [] (const std::function<void()>& call, const char* remedy) {
    try {
      call();
      ADD_FAILURE() << "accepted: " << remedy;
    }
    catch (const InvalidInput& error) {
      EXPECT_THAT (error.what(), HasSubstr (remedy));
    }
  };
  const auto run = [] (const RgbdFrame& a,
                       const RgbdFrame& b,
                       const Oversegmentation& s,
                       const RigidPose& guess = {}) {
    SceneFlowEstimator().estimate (a, b, s, guess);
  };
  const cv::Mat small (60, 80, CV_32FC1, cv::Scalar (2));
  const RgbdFrame other =
      RgbdFrame::fromImages (cv::Mat (0.25 * small), small, {80, 80, 40, 30});
  const RgbdFrame bare = RgbdFrame::fromImages ({}, view_.depth, scene_.camera);
  refused ([&] { run ({}, current_, segments_); }, "a frame is empty");
  refused ([&] { run (reference_, {}, segments_); }, "a frame is empty");
  refused ([&] { run (reference_, other, segments_); }, "and 80x60; resample");
  refused ([&] { run (reference_, bare, segments_); }, "one frame has colour");
  refused ([&] { run (reference_, current_, {}); }, "not of the reference frame");
  refused ([&] { run (other, other, segments_); }, "not of the reference frame");
  RigidPose nan;
  nan.parameters[4] = std::nan ("");
  refused ([&] { run (reference_, current_, segments_, nan); },
           "give radians and metres");
  EnergyParameters energy;
  energy.prior_weight = 0.0;
  refused (
      [&] {
        SceneFlowEstimator (energy, {}).estimate (reference_, current_, segments_);
      },
      "prior_weight must be in [1e-12, 1e12]");
  SolverParameters solver = alone();
  solver.levels = 0;
  refused ([&] { estimate (solver); }, "levels must be in [1, 10]");
}

TEST_F (Room, AbsurdGuessesDoNoHarm)
{
  for (int axis = 0; axis < 6; ++axis) {
    RigidPose guess;
    guess.parameters[axis] = 1e5;
    const auto all = errors (estimate (alone(), guess));
    EXPECT_LT (all[all.size() / 2], 0.3) << axis;
    for (const double refused : {1e39, 1e200, -1e200}) {
      guess.parameters[axis] = refused;
      EXPECT_THROW (estimate (alone(), guess), InvalidInput);
    }
  }
}

} // namespace
