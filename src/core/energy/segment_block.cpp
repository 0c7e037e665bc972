// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/segment_block.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/base/flatten.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr double kRelativeRank = 1e-12; // eigenvalues below this share of the largest

/** F with A = F F': by Cholesky, or of lower rank by eigenvectors. Flat, so
 * that no copy of Eigen's functions for aligned 6x6 matrices is left that a program's
 * own, with another alignment, could replace. */
PCL_MSF_FLATTEN Matrix6
factor (const Matrix6& a, const Vector6& b, Vector6& y)
{
  const Eigen::LLT<Eigen::Matrix<double, 6, 6>> llt (a);
  if (llt.info() == Eigen::Success && llt.rcond() > kRelativeRank) {
    y = llt.matrixL().solve (b);
    return llt.matrixL();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen (a);
  const double limit = kRelativeRank * std::max (eigen.eigenvalues()[5], 1e-300);
  Matrix6 f = Matrix6::Zero();
  y.setZero();
  for (int i = 0; i < 6; ++i)
    if (eigen.eigenvalues()[i] > limit) {
      const double root = std::sqrt (eigen.eigenvalues()[i]);
      f.col (i) = root * eigen.eigenvectors().col (i);
      y[i] = eigen.eigenvectors().col (i).dot (b) / root;
    }
  return f;
}

} // namespace

void
CompressedBlock::set (const Matrix6& information, const Vector6& gradient, double cost)
{
  residuals.fill (0.0);
  jacobian.fill (0.0);
  finite = std::isfinite (cost) && information.allFinite() && gradient.allFinite();
  if (!finite)
    return;
  if (information.trace() <= 0.0) {
    setCost (cost);
    return;
  }
  Vector6 y;
  const Matrix6 f = factor (information, gradient, y);
  for (int r = 0; r < 6; ++r) {
    residuals[r] = y[r];
    for (int c = 0; c < 6; ++c)
      jacobian[6 * r + c] = f (c, r);
  }
  residuals[6] = std::sqrt (std::max (0.0, 2.0 * cost - y.squaredNorm()));
}

void
CompressedBlock::setCost (double cost)
{
  residuals.fill (0.0);
  finite = std::isfinite (cost);
  residuals[6] = finite ? std::sqrt (std::max (0.0, 2.0 * cost)) : 0.0;
}

bool
SegmentBlockCost::Evaluate (double const* const*,
                            double* residuals,
                            double** jacobians) const
{
  std::copy (block_.residuals.begin(), block_.residuals.end(), residuals);
  if (jacobians && jacobians[0])
    std::copy (block_.jacobian.begin(), block_.jacobian.end(), jacobians[0]);
  return block_.finite;
}

} // namespace pcl_msf
