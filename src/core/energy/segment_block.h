// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/data_term.h"
#include <ceres/sized_cost_function.h>

#include <array>

namespace pcl_msf {

/** \brief A body's data terms compressed to seven residuals.
 *
 * With A = L L' and b the sums over its points and c the robust cost: y = inv (L) b
 * with Jacobian L', and sqrt (2 c - |y|^2) with Jacobian zero. Cost, gradient and
 * Gauss-Newton matrix are those of one residual per point. When A has no Cholesky
 * factor its eigenvectors give one of its rank.
 */
struct CompressedBlock {
  std::array<double, 7> residuals{};
  std::array<double, 42> jacobian{}; ///< 7 x 6, row major
  bool finite{true}; ///< false: the poses cannot be evaluated, Ceres rejects the step

  /** \brief Residuals and Jacobian of a linearized quadratic. */
  void
  set (const Matrix6& information, const Vector6& gradient, double cost);

  /** \brief Residuals of a bare cost: only their norm means something. */
  void
  setCost (double cost);
};

/** \brief Hands a CompressedBlock, filled by the evaluation callback, to Ceres. */
class SegmentBlockCost : public ceres::SizedCostFunction<7, 6> {
public:
  explicit SegmentBlockCost (const CompressedBlock& block) : block_ (block) {}

  bool
  Evaluate (double const* const* parameters,
            double* residuals,
            double** jacobians) const override;

private:
  const CompressedBlock& block_;
};

} // namespace pcl_msf
