// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include "core/energy/ceres_problem.h"
#include <ceres/crs_matrix.h>

#include <vector>

namespace pcl_msf {
namespace test {

/** \brief The energy's problem at the correspondences of the last sweep before it, in
 * double precision: smooth, as plain residuals are. */
class KeptProblem : public CeresProblem {
public:
  KeptProblem (Energy& energy, WindowState& state)
  : CeresProblem (energy, state), energy_ (energy), state_ (state)
  {}

  void
  PrepareForEvaluation (bool, bool) override
  {
    energy_.level().sweep (state_, DataTerm::Pass::LinearizeKeptInDouble);
    fill (true);
  }

private:
  Energy& energy_;
  WindowState& state_;
};

struct Evaluation {
  double cost{0.0};
  Eigen::VectorXd gradient;
  Eigen::MatrixXd gauss_newton;
};

/** \brief Evaluates a problem over these parameter blocks. */
inline Evaluation
evaluate (ceres::Problem& problem, const std::vector<double*>& blocks)
{
  ceres::Problem::EvaluateOptions options;
  options.parameter_blocks = blocks;
  Evaluation result;
  std::vector<double> gradient;
  ceres::CRSMatrix crs;
  EXPECT_TRUE (problem.Evaluate (options, &result.cost, nullptr, &gradient, &crs));
  result.gradient = Eigen::Map<Eigen::VectorXd> (gradient.data(), gradient.size());
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero (crs.num_rows, crs.num_cols);
  for (int r = 0; r < crs.num_rows; ++r)
    for (int i = crs.rows[r]; i < crs.rows[r + 1]; ++i)
      jacobian (r, crs.cols[i]) = crs.values[i];
  result.gauss_newton = jacobian.transpose() * jacobian;
  return result;
}

} // namespace test
} // namespace pcl_msf
