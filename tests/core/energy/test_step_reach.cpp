// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/energy/step_reach.h"

#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace pcl_msf;

constexpr double kFocalLength = 500.0;
const RigidPose kPose{{0.3, -0.2, 0.1, 0.2, -0.1, 0.3}};
const StepTuning kTuning{2.0, 0.25, 2.0, 0.01};

/** A body of these points, two metres away. */
std::vector<Eigen::Vector3d>
points ()
{
  return {{0.1, 0.0, 2.0}, {-0.2, 0.1, 2.1}, {0.0, -0.3, 1.8}, {0.3, 0.2, 2.05}};
}

StepReach
reachOfPoints ()
{
  BodyShape shape;
  for (const Eigen::Vector3d& p : points())
    shape.center += p / 4.0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points())
    covariance += (p - shape.center) * (p - shape.center).transpose() / 4.0;
  shape.spread = covariance.llt().matrixL();
  return {{shape}, kFocalLength, kTuning};
}

/** Root mean square motion of the points in one Gauss-Newton step, pixels. */
double
motionOfStep (const Matrix6& information, const Vector6& gradient)
{
  const Eigen::Matrix<double, 6, 6> a = information;
  const Eigen::Matrix<double, 6, 1> b = gradient;
  const Eigen::Matrix<double, 6, 1> step = a.ldlt().solve (b);
  constexpr double kSmall = 1e-6; // where motion is linear in the pose
  RigidPose there = kPose;
  for (int i = 0; i < 6; ++i)
    there.parameters[i] -= kSmall * step[i];
  double depth = 0.0;
  double squares = 0.0;
  for (const Eigen::Vector3d& p : points()) {
    squares += (there * p - kPose * p).squaredNorm() / (kSmall * kSmall) / 4.0;
    depth += (kPose * p).z() / 4.0;
  }
  return kFocalLength / depth * std::sqrt (squares);
}

struct Sums {
  Matrix6 information;
  Vector6 gradient;
};

Sums
randomSums (int seed)
{
  std::mt19937 generator (seed);
  std::normal_distribution<double> normal;
  Sums sums;
  Eigen::MatrixXd j (20, 6);
  for (int i = 0; i < 120; ++i)
    j.data()[i] = normal (generator);
  sums.information = j.transpose() * j;
  for (int i = 0; i < 6; ++i)
    sums.gradient[i] = normal (generator);
  return sums;
}

TEST (StepReach, ShortStepsAreLeftAlone)
{
  const Sums sums = randomSums (1);
  const Vector6 gradient =
      sums.gradient / motionOfStep (sums.information, sums.gradient); // one pixel
  Matrix6 damped = sums.information;
  reachOfPoints().damp (0, kPose, gradient, damped);
  EXPECT_LT ((damped - sums.information).norm(), 1e-6 * sums.information.norm());
}

TEST (StepReach, LongStepsEndWithinReach)
{
  const StepReach reach = reachOfPoints();
  for (int seed = 0; seed < 20; ++seed)
    for (const double pixels : {3.0, 10.0, 100.0}) {
      const Sums sums = randomSums (seed);
      const Vector6 gradient =
          pixels * sums.gradient / motionOfStep (sums.information, sums.gradient);
      Matrix6 damped = sums.information;
      reach.damp (0, kPose, gradient, damped);
      const double motion = motionOfStep (damped, gradient);
      EXPECT_LT (motion, 1.15 * kTuning.reach) << seed << ", " << pixels;
      EXPECT_GT (motion, 0.8 * kTuning.reach) << seed << ", " << pixels;
    }
}

TEST (StepReach, FreedomsThatNothingHoldsAreHeld)
{
  Sums sums = randomSums (2);
  sums.information.row (4).setZero();
  sums.information.col (4).setZero();
  Matrix6 damped = sums.information;
  reachOfPoints().damp (0, kPose, sums.gradient, damped);
  EXPECT_TRUE (damped.allFinite());
  EXPECT_LT (motionOfStep (damped, sums.gradient), 1.15 * kTuning.reach);
  Matrix6 nothing = Matrix6::Zero();
  reachOfPoints().damp (0, kPose, Vector6::Zero(), nothing);
  EXPECT_EQ (nothing, Matrix6::Zero());
}

TEST (StepReach, LossesShortenItAndGainsBringItBack)
{
  StepReach reach = reachOfPoints();
  const Sums sums = randomSums (3);
  const Vector6 gradient =
      50.0 * sums.gradient / motionOfStep (sums.information, sums.gradient);
  const auto motion = [&] {
    Matrix6 damped = sums.information;
    reach.damp (0, kPose, gradient, damped);
    return motionOfStep (damped, gradient);
  };
  reach.learn (0, false);
  EXPECT_NEAR (motion(), 0.5, 0.1);
  reach.learn (0, true);
  EXPECT_NEAR (motion(), 1.0, 0.2);
  for (int i = 0; i < 10; ++i)
    reach.learn (0, true);
  EXPECT_NEAR (motion(), 2.0, 0.4); // never farther than at first
}

} // namespace
