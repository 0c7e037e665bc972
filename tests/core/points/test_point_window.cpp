// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/points/carried_pair.h"
#include "core/points/chain_cost.h"
#include "core/points/point_window.h"
#include "support/box_chain.h"
#include "support/pose_matcher.h"

#include <array>
#include <cmath>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;

using Steps = std::array<std::array<double, 6>, 3>;
using Residuals = std::array<double, 12>;

const RigidPose kFirst{{0.4, -0.9, 0.3, 0.2, -0.1, 0.5}};
const RigidPose kSecond{{-0.2, 0.1, 0.5, 0.1, 0.3, -0.2}};

BodyShape
someShape ()
{
  BodyShape shape;
  shape.center = Eigen::Vector3d (0.3, -0.2, 0.1);
  shape.spread << 0.1, 0.02, 0.0, 0.0, 0.2, 0.01, 0.03, 0.0, 0.05;
  return shape;
}

Residuals
residualsOf (const ChainCost& cost, const Steps& steps)
{
  const std::array<const double*, 3> blocks{
      steps[0].data(), steps[1].data(), steps[2].data()};
  Residuals r{};
  EXPECT_TRUE (cost.Evaluate (blocks.data(), r.data(), nullptr));
  return r;
}

RigidPose
shiftBy (double x)
{
  return RigidPose{{0.0, 0.0, 0.0, x, 0.0, 0.0}};
}

TEST (ChainCost, IsHowFarApartTheDirectMotionAndTheChainPutASegment)
{
  BodyShape shape;
  shape.center = Eigen::Vector3d (1.0, 0.0, 0.0);
  shape.spread.diagonal() << 0.5, 0.25, 0.125;
  const CenteredMotion still (RigidPose(), shape.center);
  const CenteredMotion near (shiftBy (0.5), shape.center);
  const CenteredMotion on (shiftBy (0.3), {1.5, 0.0, 0.0});
  // Shifts of 1 against 0.5 + 0.3, twice.
  const CenteredMotion far (shiftBy (1.0), shape.center);
  const Residuals shifts = residualsOf (ChainCost (far, near, on, shape, 2.0), {});
  EXPECT_NEAR (shifts[0], 0.4, 1e-12);
  for (int k = 1; k < 12; ++k)
    EXPECT_NEAR (shifts[k], 0.0, 1e-12) << k;
  // A right angle about z against nothing: the centre goes from x to y, spreads, too.
  const CenteredMotion turned (RigidPose{{0.0, 0.0, M_PI / 2.0, 0.0, 0.0, 0.0}},
                               shape.center);
  const Residuals turns =
      residualsOf (ChainCost (turned, still, still, shape, 1.0), {});
  const Residuals expected{
      -1.0, 1.0, 0.0, -0.5, 0.5, 0.0, -0.25, -0.25, 0.0, 0.0, 0.0, 0.0};
  for (int k = 0; k < 12; ++k)
    EXPECT_NEAR (turns[k], expected[k], 1e-12) << k;
}

TEST (ChainCost, VanishesWhereTheChainIsTheMotion)
{
  const BodyShape shape = someShape();
  const Eigen::Vector3d at (0.25, -0.25, 0.2); // not the shape's centre
  const CenteredMotion first (kFirst, at);
  const CenteredMotion second (kSecond, kFirst * at);
  const CenteredMotion direct (kSecond * kFirst, at);
  for (const double r : residualsOf (ChainCost (direct, first, second, shape, 3.0), {}))
    EXPECT_NEAR (r, 0.0, 1e-12);
}

TEST (ChainCost, DerivativesAgreeWithDifferences)
{
  const BodyShape shape = someShape();
  const Eigen::Vector3d at (0.25, -0.25, 0.2);
  const CenteredMotion first (kFirst, at);
  const CenteredMotion second (kSecond, kFirst * at);
  const CenteredMotion direct (RigidPose{{0.1, 0.2, 0.9, 0.0, 0.3, 0.1}}, at);
  const ChainCost cost (direct, first, second, shape, 0.7);
  Steps steps{{{0.1, -0.2, 0.15, 0.05, 0.02, -0.03},
               {-0.3, 0.1, 0.2, -0.01, 0.04, 0.06},
               {0.05, 0.25, -0.1, 0.02, -0.05, 0.01}}};
  const std::array<const double*, 3> blocks{
      steps[0].data(), steps[1].data(), steps[2].data()};
  std::array<std::array<double, 72>, 3> j{};
  std::array<double*, 3> jacobians{j[0].data(), j[1].data(), j[2].data()};
  Residuals r{};
  ASSERT_TRUE (cost.Evaluate (blocks.data(), r.data(), jacobians.data()));
  for (int block = 0; block < 3; ++block)
    for (int c = 0; c < 6; ++c) {
      constexpr double h = 1e-6;
      Steps up = steps;
      Steps down = steps;
      up[block][c] += h;
      down[block][c] -= h;
      const Residuals above = residualsOf (cost, up);
      const Residuals below = residualsOf (cost, down);
      for (int k = 0; k < 12; ++k)
        EXPECT_NEAR (j[block][6 * k + c], (above[k] - below[k]) / (2.0 * h), 1e-6)
            << block << " " << k << " " << c;
    }
}

TEST (SegmentShapes, HoldTheMeanSquaredDistanceOfAnyMotion)
{
  PointSamples samples;
  SurfaceSegments segments;
  segments.seeds = {0, 1};
  segments.centroids = {Eigen::Vector3d::Zero(), Eigen::Vector3d (1.0, 2.0, 3.0)};
  for (int i = 0; i < 40; ++i)
    samples.points.emplace_back (0.3 * std::cos (1.7 * i), 0.1 * i, std::sin (2.3 * i));
  const std::vector<BodyShape> shapes =
      segmentShapes (samples, std::vector<int> (40, 0), segments);
  EXPECT_EQ (shapes[1].center, segments.centroids[1]); // of no point
  EXPECT_EQ (shapes[1].spread.norm(), 0.0);
  const CenteredMotion still (RigidPose(), shapes[0].center);
  const CenteredMotion moved (kFirst, shapes[0].center);
  double squares = 0.0;
  for (const double r :
       residualsOf (ChainCost (moved, still, still, shapes[0], 1.0), {}))
    squares += r * r;
  double mean = 0.0;
  for (const auto& p : samples.points)
    mean += (kFirst * p.cast<double>() - p.cast<double>()).squaredNorm() / 40.0;
  EXPECT_NEAR (squares, mean, 1e-5);
}

/** A chain that bends on, and each target's own solve. */
class PointWindow : public ::testing::Test {
protected:
  PointWindow()
  {
    chain_.boxes = 2;
    source_ = drawChain (chain_, 2000, false, 1).points;
    tuning_ = currentTuning();
    for (int t = 0; t < 2; ++t) {
      const Eigen::Vector3d turn (0.03, -0.05, 0.04);
      chain_.angle = 0.1 * (t + 1);
      for (int k = 0; k < 3; ++k)
        chain_.root.parameters[k] = (t + 1) * turn[k];
      truth_.push_back (chain_);
      const std::vector<Eigen::Vector3f> target =
          drawChain (chain_, 2000, true, 2 + t).points;
      PointFrame& frame = frames_[t];
      frame.clouds =
          t == 0 ? preparePointClouds (source_, target, tuning_, 1)
                 : withTarget (frames_[0].clouds, target, "target 2", tuning_, 1);
      frame.before = t - 1;
    }
    for (PointFrame& frame : frames_) {
      frame.solve = std::make_unique<PointSolve> (
          frame.clouds, frame.prior, RigidPose(), tuning_, 1, progress_);
      frame.solve->run();
    }
  }
  /** Mean distance of segments' centres from the truth, in sizes. */
  double
  error (int frame) const
  {
    const PointSolve& solve = *frames_[frame].solve;
    const PointClouds& clouds = frames_[frame].clouds;
    double sum = 0.0;
    for (int k = 0; k < solve.segments().size(); ++k) {
      const Eigen::Vector3d& c = solve.segments().centroids[k];
      const Eigen::Vector3d given = clouds.size * c + clouds.center;
      const int box = given.x() < chain_.size.x() ? 0 : 1;
      const Eigen::Vector3d there =
          (truth_[frame].pose (box) * given - clouds.center) / clouds.size;
      sum += (solve.poses()[k] * c - there).norm();
    }
    return sum / solve.segments().size();
  }

  BoxChain chain_;
  std::vector<BoxChain> truth_;
  std::vector<Eigen::Vector3f> source_;
  Tuning tuning_;
  SolverParameters solver_;
  SolveProgress progress_{solver_, 100};
  std::vector<PointFrame> frames_{std::vector<PointFrame> (2)};
};

TEST_F (PointWindow, CarriesTheSegmentsToTheTargetsPoints)
{
  PointEnergyWeights weights;
  weights.unit = frames_[0].solve->segments().radius;
  CarriedPair pair (frames_[0], frames_[1], weights, 0.02, 1);
  const PointSamples& samples = pair.samples();
  ASSERT_GT (samples.size(), 1500);
  // Where the truth of both frames takes them.
  const PointClouds& clouds = frames_[0].clouds;
  double sum = 0.0;
  const MovedPoints moved = movePoints (samples, pair.poses(), 1);
  for (int i = 0; i < samples.size(); ++i) {
    const Eigen::Vector3d p = clouds.asGiven (samples.points[i]).cast<double>();
    double least = 1.0;
    for (int box = 0; box < 2; ++box) {
      const Eigen::Vector3d truth =
          truth_[1].pose (box) * (truth_[0].pose (box).inverse() * p);
      least = std::min (
          least, (clouds.asGiven (moved.points[i]).cast<double>() - truth).norm());
    }
    sum += least;
  }
  EXPECT_LT (sum / samples.size(), 5e-3);
  const SurfaceSegments& segments = frames_[0].solve->segments();
  for (int k = 0; k < segments.size(); k += 50)
    EXPECT_THAT (pair.poses()[k] * frames_[0].solve->poses()[k],
                 test::isNear (frames_[1].solve->poses()[k], 1e-9, 1e-9));
}

TEST_F (PointWindow, BringsBackAFrameThatWentAstray)
{
  const double first = error (0);
  const double second = error (1);
  ASSERT_LT (second, 0.01);
  const RigidPose astray{{0.01, 0.0, 0.0, 0.005, 0.01, -0.005}};
  for (RigidPose& pose : frames_[1].solve->poses())
    pose = astray * pose;
  EXPECT_GT (error (1), 2.0 * second);
  solveJointly (frames_, 0.1, tuning_.points, 1, progress_);
  EXPECT_LT (error (0), 1.1 * first);
  EXPECT_LT (error (1), 1.5 * second);
}

TEST_F (PointWindow, WithoutAWeightEachFrameStaysAsItIs)
{
  const std::vector<RigidPose> before = frames_[1].solve->poses();
  const int steps = progress_.iterations();
  solveJointly (frames_, 0.0, tuning_.points, 1, progress_);
  EXPECT_EQ (progress_.iterations(), steps);
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_EQ (frames_[1].solve->poses()[k].parameters, before[k].parameters);
}

} // namespace
