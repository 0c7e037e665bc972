// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/energy/eliminated_coupling.h"
#include <ceres/gradient_checker.h>

#include <cmath>
#include <random>

namespace {

using namespace pcl_msf;

const SegmentLink kLink{0, 1, {0.4, -0.2, 2.0}, 0.3};
constexpr CouplingScale kScale{0.7, 1.3, 250.0};

RigidPose
randomPose (std::mt19937& generator, double angle)
{
  std::uniform_real_distribution<double> uniform (-1.0, 1.0);
  RigidPose pose;
  Eigen::Vector3d axis (uniform (generator), uniform (generator), uniform (generator));
  axis.normalize();
  for (int i = 0; i < 3; ++i) {
    pose.parameters[i] = angle * axis[i];
    pose.parameters[3 + i] = 0.5 * uniform (generator);
  }
  return pose;
}

TEST (PoseDifference, MetricFormByHand)
{
  // First: a quarter turn about z and a shift; second: rest.
  RigidPose first;
  first.parameters = {0.0, 0.0, M_PI / 2, 0.1, 0.2, 0.3};
  const Vector6 d =
      poseDifference (first, RigidPose{}, kLink, kScale.unit, PoseDifference::Metric);
  // (0.4, -0.2, 2) turns to (0.2, 0.4, 2).
  EXPECT_NEAR (d[0], 250.0 * (0.2 + 0.1 - 0.4), 1e-9);
  EXPECT_NEAR (d[1], 250.0 * (0.4 + 0.2 + 0.2), 1e-9);
  EXPECT_NEAR (d[2], 250.0 * 0.3, 1e-9);
  EXPECT_NEAR (d[3], 0.0, 1e-9);
  EXPECT_NEAR (d[4], 0.0, 1e-9);
  EXPECT_NEAR (d[5], 250.0 * 0.3 * M_PI / 2, 1e-9);
}

TEST (PoseDifference, ParametersFormByHand)
{
  RigidPose first;
  RigidPose second;
  first.parameters = {1, 2, 3, 4, 5, 6};
  second.parameters = {0.5, 0.5, 0.5, 1, 1, 1};
  const Vector6 d =
      poseDifference (first, second, kLink, kScale.unit, PoseDifference::Parameters);
  const double expected[6] = {0.5, 1.5, 2.5, 3, 4, 5};
  for (int i = 0; i < 6; ++i)
    EXPECT_DOUBLE_EQ (d[i], expected[i]);
}

class CouplingCost : public testing::TestWithParam<std::tuple<PoseDifference, double>> {
};

TEST_P (CouplingCost, ResidualsAreTheWeightedDifferenceAndPrior)
{
  const auto [form, angle] = GetParam();
  std::mt19937 generator (7);
  const RigidPose first = randomPose (generator, angle);
  const RigidPose second = randomPose (generator, 0.5 * angle);
  const double w = 0.6;
  const double* parameters[] = {first.parameters.data(), second.parameters.data(), &w};
  double r[7];
  ASSERT_TRUE (
      PoseCouplingCost (kLink, kScale, form).Evaluate (parameters, r, nullptr));
  const Vector6 d = poseDifference (first, second, kLink, kScale.unit, form);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR (r[i], 0.7 * 0.36 * d[i], 1e-9);
  EXPECT_NEAR (r[6], 1.3 * 0.64, 1e-12);
}

TEST_P (CouplingCost, JacobiansMatchNumericalOnes)
{
  const auto [form, angle] = GetParam();
  std::mt19937 generator (8);
  const PoseCouplingCost cost (kLink, kScale, form);
  const std::vector<const ceres::Manifold*>* flat = nullptr;
  const ceres::GradientChecker checker (&cost, flat, ceres::NumericDiffOptions{});
  for (int trial = 0; trial < 10; ++trial) {
    const RigidPose first = randomPose (generator, angle);
    const RigidPose second = randomPose (generator, 0.7 * angle);
    const double w = 0.2 + 0.1 * trial;
    const double* parameters[] = {
        first.parameters.data(), second.parameters.data(), &w};
    ceres::GradientChecker::ProbeResults results;
    // Its own verdict is relative per entry, and entries vanish at small angles.
    checker.Probe (parameters, 1e-6, &results);
    ASSERT_TRUE (results.return_value);
    for (int block = 0; block < 3; ++block)
      EXPECT_LT ((results.jacobians[block] - results.numeric_jacobians[block]).norm(),
                 1e-8 * results.numeric_jacobians[block].norm());
  }
}

TEST_P (CouplingCost, ShiftsDifferByTheirDifference)
{
  const auto [form, angle] = GetParam();
  std::mt19937 generator (9);
  const RigidPose pose = randomPose (generator, angle);
  RigidPose shifted = pose;
  shifted.parameters[4] += 0.25;
  const double w = 1.0;
  const double* parameters[] = {pose.parameters.data(), shifted.parameters.data(), &w};
  double r[7];
  ASSERT_TRUE (
      PoseCouplingCost (kLink, kScale, form).Evaluate (parameters, r, nullptr));
  const bool metric = form == PoseDifference::Metric;
  const double shift = -0.7 * 0.25 * (metric ? kScale.unit : 1.0);
  for (int i = 0; i < 7; ++i)
    EXPECT_NEAR (r[i], i == (metric ? 1 : 4) ? shift : 0.0, 1e-9) << i;
}

/** Residuals and Jacobians of the lifted form, the weight at its optimum. */
struct Lifted {
  Eigen::Matrix<double, 7, 1> residuals;
  Eigen::Matrix<double, 7, 13> jacobian; ///< pose j, pose h, w
};

Lifted
liftedAt (const RigidPose& first, const RigidPose& second, PoseDifference form)
{
  const Vector6 d = poseDifference (first, second, kLink, kScale.unit, form);
  const double w = optimalWeight (d.squaredNorm(), 0.7 * 0.7, 1.3 * 1.3);
  const double* parameters[] = {first.parameters.data(), second.parameters.data(), &w};
  double j[2][42];
  double jw[7];
  double* jacobians[] = {j[0], j[1], jw};
  Lifted at;
  EXPECT_TRUE (PoseCouplingCost (kLink, kScale, form)
                   .Evaluate (parameters, at.residuals.data(), jacobians));
  for (int r = 0; r < 7; ++r) {
    for (int c = 0; c < 12; ++c)
      at.jacobian (r, c) = j[c / 6][6 * r + c % 6];
    at.jacobian (r, 12) = jw[r];
  }
  return at;
}

TEST_P (CouplingCost, EliminatedWeightLeavesTheSchurComplement)
{
  const auto [form, angle] = GetParam();
  std::mt19937 generator (12);
  for (int trial = 0; trial < 10; ++trial) {
    const RigidPose first = randomPose (generator, angle);
    const RigidPose second = trial == 0 ? first : randomPose (generator, 0.7 * angle);
    const double* parameters[] = {first.parameters.data(), second.parameters.data()};
    Vector6 r;
    double j[2][36];
    double* jacobians[] = {j[0], j[1]};
    ASSERT_TRUE (EliminatedCouplingCost (kLink, kScale, form)
                     .Evaluate (parameters, r.data(), jacobians));
    Eigen::Matrix<double, 6, 12> jacobian;
    for (int c = 0; c < 12; ++c)
      for (int row = 0; row < 6; ++row)
        jacobian (row, c) = j[c / 6][6 * row + c % 6];
    const Lifted lifted = liftedAt (first, second, form);
    EXPECT_NEAR (r.squaredNorm(),
                 lifted.residuals.squaredNorm(),
                 1e-9 * lifted.residuals.squaredNorm() + 1e-20);
    const Eigen::Matrix<double, 12, 1> gradient =
        lifted.jacobian.leftCols<12>().transpose() * lifted.residuals;
    EXPECT_LT ((jacobian.transpose() * r - gradient).norm(),
               1e-9 * gradient.norm() + 1e-12);
    const Eigen::Matrix<double, 13, 13> full =
        lifted.jacobian.transpose() * lifted.jacobian;
    const Eigen::Matrix<double, 12, 1> mixed = full.topRightCorner<12, 1>();
    const double across = full (12, 12);
    const double size = full.topLeftCorner<12, 12>().norm();
    const Eigen::Matrix<double, 12, 12> schur =
        full.topLeftCorner<12, 12>() - mixed * mixed.transpose() / across;
    EXPECT_LT ((jacobian.transpose() * jacobian - schur).norm(), 1e-9 * size);
  }
}

INSTANTIATE_TEST_SUITE_P (
    FormsAndAngles,
    CouplingCost,
    testing::Combine (testing::Values (PoseDifference::Metric,
                                       PoseDifference::Parameters),
                      testing::Values (0.0, 1e-9, 0.01, 1.0, 3.0)));

TEST (OptimalWeight, MinimizesTheLiftedEnergy)
{
  for (const double gamma : {0.01, 1.0, 20.0})
    for (const double eta : {0.02, 3.0})
      for (const double d2 : {0.0, 1e-3, 1.0, 400.0}) {
        const auto energy = [&] (double w) {
          const double s = w * w;
          return gamma * s * s * d2 + eta * (1.0 - s) * (1.0 - s);
        };
        const double found = optimalWeight (d2, gamma, eta);
        double best = 1e300;
        for (double w = 0.0; w <= 1.5; w += 1e-4)
          best = std::min (best, energy (w));
        EXPECT_LE (energy (found), best * (1.0 + 1e-9) + 1e-15);
      }
}

} // namespace
