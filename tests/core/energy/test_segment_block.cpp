// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Core>

#include "core/energy/segment_block.h"

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace pcl_msf;
using RowMajor = Eigen::Matrix<double, 7, 6, Eigen::RowMajor>;

/** What a residual vector r with Jacobian j says: A, b, cost. */
struct Sums {
  Matrix6 a;
  Vector6 b;
  double cost;
};

Sums
randomSums (std::mt19937& generator, int rows, double scale)
{
  std::normal_distribution<double> normal (0.0, 1.0);
  Eigen::MatrixXd j (rows, 6);
  Eigen::VectorXd r (rows);
  for (int i = 0; i < rows; ++i) {
    r[i] = normal (generator);
    for (int c = 0; c < 6; ++c)
      j (i, c) = scale * normal (generator) * (c < 3 ? 30.0 : 1.0);
  }
  return {j.transpose() * j, j.transpose() * r, 0.5 * r.squaredNorm()};
}

/** The block as Ceres sees it. */
Sums
seenByCeres (const CompressedBlock& block)
{
  const SegmentBlockCost cost (block);
  const double pose[6] = {};
  const double* parameters[] = {pose};
  Eigen::Matrix<double, 7, 1> r;
  RowMajor j;
  double* jacobians[] = {j.data()};
  EXPECT_TRUE (cost.Evaluate (parameters, r.data(), jacobians));
  return {j.transpose() * j, j.transpose() * r, 0.5 * r.squaredNorm()};
}

void
expectSame (const Sums& found, const Sums& wanted, double tolerance)
{
  EXPECT_LT ((found.a - wanted.a).norm(), tolerance * wanted.a.norm());
  EXPECT_LT ((found.b - wanted.b).norm(), tolerance * wanted.b.norm());
  EXPECT_NEAR (found.cost, wanted.cost, tolerance * wanted.cost);
}

class SegmentBlock : public testing::TestWithParam<int> {};

TEST_P (SegmentBlock, ReproducesSumsOfAnyRank)
{
  std::mt19937 generator (GetParam());
  for (const double scale : {1e-3, 1.0, 1e3})
    for (int trial = 0; trial < 20; ++trial) {
      const Sums sums = randomSums (generator, GetParam(), scale);
      CompressedBlock block;
      block.set (sums.a, sums.b, sums.cost);
      // The square root of a vanishing remainder costs half of the digits.
      expectSame (seenByCeres (block), sums, GetParam() < 6 ? 1e-7 : 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P (Rows, SegmentBlock, testing::Values (1, 2, 3, 4, 5, 6, 500));

TEST (SegmentBlockEdges, RobustCostAboveTheQuadraticIsKept)
{
  std::mt19937 generator (3);
  Sums sums = randomSums (generator, 100, 1.0);
  sums.cost += 17.0; // hidden points
  CompressedBlock block;
  block.set (sums.a, sums.b, sums.cost);
  expectSame (seenByCeres (block), sums, 1e-9);
}

TEST (SegmentBlockEdges, NothingKnownIsJustACost)
{
  CompressedBlock block;
  block.set (Matrix6::Zero(), Vector6::Zero(), 2.5);
  const Sums seen = seenByCeres (block);
  EXPECT_EQ (seen.a.norm(), 0.0);
  EXPECT_EQ (seen.b.norm(), 0.0);
  EXPECT_DOUBLE_EQ (seen.cost, 2.5);
}

TEST (SegmentBlockEdges, BareCostMatchesLinearizedCost)
{
  std::mt19937 generator (4);
  const Sums sums = randomSums (generator, 50, 1.0);
  CompressedBlock linearized;
  linearized.set (sums.a, sums.b, sums.cost);
  CompressedBlock bare;
  bare.setCost (sums.cost);
  EXPECT_NEAR (seenByCeres (bare).cost, seenByCeres (linearized).cost, 1e-12);
}

TEST (SegmentBlockEdges, NaNIsRefusedAndDoesNotComeOut)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::mt19937 generator (5);
  const Sums good = randomSums (generator, 50, 1.0);
  for (int place = 0; place < 3; ++place) {
    Sums bad = good;
    (place == 0 ? bad.a (2, 2) : place == 1 ? bad.b[4] : bad.cost) = nan;
    CompressedBlock block;
    block.set (bad.a, bad.b, bad.cost);
    const SegmentBlockCost cost (block);
    const double pose[6] = {};
    const double* parameters[] = {pose};
    double residuals[7];
    EXPECT_FALSE (cost.Evaluate (parameters, residuals, nullptr)) << place;
    for (const double r : residuals)
      EXPECT_TRUE (std::isfinite (r)) << place;
    block.set (good.a, good.b, good.cost);
    EXPECT_TRUE (cost.Evaluate (parameters, residuals, nullptr)) << place;
  }
}

TEST (SegmentBlockEdges, JacobianIsOptional)
{
  CompressedBlock block;
  block.setCost (0.5);
  const SegmentBlockCost cost (block);
  const double pose[6] = {};
  const double* parameters[] = {pose};
  double residuals[7];
  double* jacobians[] = {nullptr};
  EXPECT_TRUE (cost.Evaluate (parameters, residuals, nullptr));
  EXPECT_TRUE (cost.Evaluate (parameters, residuals, jacobians));
  EXPECT_DOUBLE_EQ (residuals[6], 1.0);
}

} // namespace
