// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/minimize.h"

#include "core/energy/ceres_problem.h"
#include "core/energy/sparse_cholesky.h"
#include <ceres/iteration_callback.h>
#include <ceres/solver.h>

#include <cmath>

namespace pcl_msf {

namespace {

constexpr double kSettled = 0.01; // relative change of the last solve: none

/** Tells the monitor each iteration and the energy by term, and ends the solve when it
 * says so. Ceres must update the state first (update_state_every_iteration). */
class MonitorCallback : public ceres::IterationCallback {
public:
  MonitorCallback (SolveMonitor& monitor,
                   const Energy& energy,
                   const WindowState& state)
  : monitor_ (monitor), energy_ (energy), state_ (state)
  {}

  ceres::CallbackReturnType
  operator() (const ceres::IterationSummary& summary) override
  {
    if (summary.step_is_successful) // then the last sweep was at the new state
      monitor_.noteTerms (energy_.presentCost (state_));
    const bool go_on =
        summary.iteration == 0 ? !monitor_.stopped() : monitor_.step (summary.cost);
    return go_on ? ceres::SOLVER_CONTINUE : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }

private:
  SolveMonitor& monitor_;
  const Energy& energy_;
  const WindowState& state_;
};

ceres::Solver::Options
ceresOptions (const SolverParameters& solver, const SolveMonitor& monitor)
{
  ceres::Solver::Options options;
  options.minimizer_type = ceres::TRUST_REGION;
  options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  if (solver.linear_solver == LinearSolver::Cgnr)
    options.linear_solver_type = ceres::CGNR;
  else
    useSparseCholesky (options);
  options.preconditioner_type = ceres::JACOBI;
  options.eta = 0.1;
  options.use_nonmonotonic_steps = true; // points appear and hide
  options.max_num_iterations = solver.max_iterations;
  options.function_tolerance = solver.function_tolerance;
  options.parameter_tolerance = solver.parameter_tolerance;
  options.gradient_tolerance = 0.0;
  options.max_solver_time_in_seconds = monitor.secondsLeft();
  options.logging_type = ceres::SILENT;
  options.num_threads = 1; // the sweep is parallel; the rest is small
  options.update_state_every_iteration = true;
  return options;
}

} // namespace

bool
SolveOutcome::settled() const
{
  const double change = initial.total() - final.total();
  return iterations > 0 && !failed &&
         (converged || std::abs (change) < kSettled * initial.total());
}

SolveOutcome
minimize (Energy& energy,
          const SolverParameters& solver,
          SolveMonitor& monitor,
          WindowState& state)
{
  SolveOutcome outcome;
  energy.relaxWeights (state);
  outcome.initial = energy.evaluate (state);
  CeresProblem problem (energy, state);
  problem.startsLinearized();
  monitor.noteTerms (outcome.initial);
  MonitorCallback callback (monitor, energy, state);
  ceres::Solver::Options options = ceresOptions (solver, monitor);
  options.callbacks = {&callback};
  ceres::Solver::Summary summary;
  if (solver.max_iterations > 0 && !monitor.stopped())
    ceres::Solve (options, &problem.problem(), &summary);
  energy.relaxWeights (state);
  outcome.final = energy.evaluate (state);
  outcome.iterations = static_cast<int> (summary.iterations.size());
  outcome.converged = summary.termination_type == ceres::CONVERGENCE;
  outcome.failed = summary.termination_type == ceres::FAILURE && outcome.iterations > 0;
  return outcome;
}

} // namespace pcl_msf
