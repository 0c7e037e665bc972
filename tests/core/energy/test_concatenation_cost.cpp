// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/energy/concatenation_cost.h"
#include <ceres/autodiff_cost_function.h>
#include <ceres/gradient_checker.h>
#include <ceres/rotation.h>

#include <random>

namespace {

using namespace pcl_msf;

BodyShape
someShape ()
{
  BodyShape shape;
  shape.center = {0.3, -0.2, 2.1};
  shape.spread << 0.2, 0.0, 0.0, 0.05, 0.15, 0.0, -0.02, 0.03, 0.1;
  return shape;
}

RigidPose
somePose (std::mt19937& generator, double size)
{
  std::uniform_real_distribution<double> uniform (-size, size);
  RigidPose pose;
  for (double& parameter : pose.parameters)
    parameter = uniform (generator);
  return pose;
}

/** Eq. 14 over three steps, the second walked backwards, written down plainly. */
struct PlainConcatenation {
  BodyShape shape;
  double scale;

  template <typename T>
  static void
  walk (const T* pose, bool inverse, bool point, T* v)
  {
    T w[3] = {v[0], v[1], v[2]};
    if (!inverse) {
      ceres::AngleAxisRotatePoint (pose, w, v);
      for (int i = 0; i < 3; ++i)
        v[i] += point ? pose[3 + i] : T (0.0);
      return;
    }
    const T back[3] = {-pose[0], -pose[1], -pose[2]};
    for (int i = 0; i < 3; ++i)
      w[i] -= point ? pose[3 + i] : T (0.0);
    ceres::AngleAxisRotatePoint (back, w, v);
  }

  template <typename T>
  bool
  operator() (const T* own, const T* a, const T* b, const T* c, T* residual) const
  {
    for (int column = 0; column < 4; ++column) {
      T direct[3], chained[3];
      for (int i = 0; i < 3; ++i)
        direct[i] = chained[i] =
            T (column == 0 ? shape.center[i] : shape.spread (i, column - 1));
      walk (own, false, column == 0, direct);
      walk (a, false, column == 0, chained);
      walk (b, true, column == 0, chained);
      walk (c, false, column == 0, chained);
      for (int i = 0; i < 3; ++i)
        residual[3 * column + i] = scale * (direct[i] - chained[i]);
    }
    return true;
  }
};

TEST (ConcatenationCost, ShiftsByHand)
{
  RigidPose own, first, second;
  own.parameters = {0, 0, 0, 0.30, 0.0, 0.0};
  first.parameters = {0, 0, 0, 0.10, 0.0, 0.02};
  second.parameters = {0, 0, 0, 0.15, 0.0, -0.02};
  const ConcatenationCost cost (someShape(), {false, false}, 100.0);
  const double* blocks[] = {
      own.parameters.data(), first.parameters.data(), second.parameters.data()};
  double r[12];
  ASSERT_TRUE (cost.Evaluate (blocks, r, nullptr));
  EXPECT_NEAR (r[0], 100.0 * 0.05, 1e-9);
  for (int i = 1; i < 12; ++i)
    EXPECT_NEAR (r[i], 0.0, 1e-9) << i;
}

TEST (ConcatenationCost, IsTheMeanSquaredDisplacementOfThePoints)
{
  std::mt19937 generator (3);
  const BodyShape shape = someShape();
  const RigidPose own = somePose (generator, 0.2);
  const RigidPose first = somePose (generator, 0.2);
  const RigidPose second = somePose (generator, 0.2);
  const ConcatenationCost cost (shape, {false, true}, 1.0);
  const double* blocks[] = {
      own.parameters.data(), first.parameters.data(), second.parameters.data()};
  Eigen::Matrix<double, 12, 1> r;
  ASSERT_TRUE (cost.Evaluate (blocks, r.data(), nullptr));
  // Points with that mean and covariance: the centre plus and minus root 3 spreads.
  const RigidPose chain = concatenate ({first, second}, {false, true});
  double sum = 0.0;
  for (int column = 0; column < 3; ++column)
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d p =
          shape.center + sign * std::sqrt (3.0) * shape.spread.col (column);
      sum += (own * p - chain * p).squaredNorm() / 6.0;
    }
  EXPECT_NEAR (r.squaredNorm(), sum, 1e-9);
}

TEST (ConcatenationCost, VanishesForTheProduct)
{
  std::mt19937 generator (4);
  const RigidPose first = somePose (generator, 0.4);
  const RigidPose second = somePose (generator, 0.4);
  const RigidPose own = concatenate ({first, second}, {true, false});
  const ConcatenationCost cost (someShape(), {true, false}, 300.0);
  const double* blocks[] = {
      own.parameters.data(), first.parameters.data(), second.parameters.data()};
  double r[12];
  ASSERT_TRUE (cost.Evaluate (blocks, r, nullptr));
  for (const double value : r)
    EXPECT_NEAR (value, 0.0, 1e-9);
}

TEST (ConcatenationCost, ResidualsAndJacobiansMatchAutomaticOnes)
{
  std::mt19937 generator (5);
  const BodyShape shape = someShape();
  const ConcatenationCost cost (shape, {false, true, false}, 50.0);
  ceres::AutoDiffCostFunction<PlainConcatenation, 12, 6, 6, 6, 6> plain (
      new PlainConcatenation{shape, 50.0});
  for (const double size : {1e-9, 0.05, 1.0}) {
    RigidPose poses[4];
    const double* blocks[4];
    for (int i = 0; i < 4; ++i) {
      poses[i] = somePose (generator, size);
      blocks[i] = poses[i].parameters.data();
    }
    Eigen::Matrix<double, 12, 1> a, b;
    Eigen::Matrix<double, 12, 6, Eigen::RowMajor> ja[4], jb[4];
    double* pa[] = {ja[0].data(), ja[1].data(), ja[2].data(), ja[3].data()};
    double* pb[] = {jb[0].data(), jb[1].data(), jb[2].data(), jb[3].data()};
    ASSERT_TRUE (cost.Evaluate (blocks, a.data(), pa));
    ASSERT_TRUE (plain.Evaluate (blocks, b.data(), pb));
    EXPECT_LT ((a - b).norm(), 1e-9);
    for (int i = 0; i < 4; ++i)
      EXPECT_LT ((ja[i] - jb[i]).norm(), 1e-7 * jb[i].norm()) << "block " << i;
  }
}

TEST (ConcatenationCost, JacobiansMatchNumericalOnes)
{
  std::mt19937 generator (6);
  const ConcatenationCost cost (someShape(), {true, false}, 50.0);
  const std::vector<const ceres::Manifold*>* flat = nullptr;
  const ceres::GradientChecker checker (&cost, flat, ceres::NumericDiffOptions{});
  RigidPose poses[3];
  const double* blocks[3];
  for (int i = 0; i < 3; ++i) {
    poses[i] = somePose (generator, 0.6);
    blocks[i] = poses[i].parameters.data();
  }
  ceres::GradientChecker::ProbeResults results;
  checker.Probe (blocks, 1e-6, &results);
  ASSERT_TRUE (results.return_value);
  for (int i = 0; i < 3; ++i)
    EXPECT_LT ((results.jacobians[i] - results.numeric_jacobians[i]).norm(),
               1e-7 * results.numeric_jacobians[i].norm());
}

} // namespace
