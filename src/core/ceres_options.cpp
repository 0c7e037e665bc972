// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/ceres_options.h"

namespace pcl_msf {

ceres::Solver::Options
ceresOptions (const SolverParameters& solver, const SolveMonitor& monitor)
{
  ceres::Solver::Options options;
  options.minimizer_type = ceres::TRUST_REGION;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  options.linear_solver_type = solver.linear_solver == LinearSolver::Cgnr
                                   ? ceres::CGNR
                                   : ceres::SPARSE_NORMAL_CHOLESKY;
  options.preconditioner_type = ceres::JACOBI;
  options.eta = 1e-2;
  options.use_nonmonotonic_steps = true;
  options.max_num_iterations = solver.max_iterations;
  options.function_tolerance = solver.function_tolerance;
  options.parameter_tolerance = solver.parameter_tolerance;
  options.gradient_tolerance = 0.0;
  options.max_solver_time_in_seconds = monitor.secondsLeft();
  options.logging_type = ceres::SILENT;
  options.num_threads = 1; // the sweep is parallel; the rest is small
  return options;
}

} // namespace pcl_msf
