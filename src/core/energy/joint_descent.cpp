// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/joint_descent.h"

#include "core/energy/sparse_cholesky.h"

#include <cmath>
#include <limits>

namespace pcl_msf {

namespace {

ceres::Solver::Options
oneStep (const SolverParameters& solver)
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
  options.max_num_iterations = 1;
  // Ceres proposes; what is taken is judged here.
  options.min_relative_decrease = std::numeric_limits<double>::max();
  options.function_tolerance = 0.0;
  options.parameter_tolerance = 0.0;
  options.gradient_tolerance = 0.0;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1; // no second pool, none in a forked process
  return options;
}

std::vector<StepReach>
reachOf (Energy& energy, const WindowState& state)
{
  std::vector<StepReach> reach;
  const WindowLevel& level = energy.level();
  for (const int p : level.used())
    reach.emplace_back (
        bodyShapes (level.pixels (energy.frameOf (p)), state.body_of, state.bodies()),
        level.focalLength(),
        energy.stepTuning());
  return reach;
}

} // namespace

JointDescent::JointDescent (Energy& energy,
                            const SolverParameters& solver,
                            WindowState& state)
: energy_ (energy)
, state_ (state)
, reach_ (reachOf (energy, state))
, problem_ (energy, state)
, options_ (oneStep (solver))
, parameter_tolerance_ (solver.parameter_tolerance)
, costs_ (energy.bodyCosts (state))
{
  problem_.setReach (&reach_);
}

bool
JointDescent::step (double seconds_left)
{
  const WindowState before = state_;
  energy_.level().rememberSums();
  problem_.startsLinearized();
  options_.max_solver_time_in_seconds = seconds_left;
  ceres::Solver::Summary summary;
  ceres::Solve (options_, &problem_.problem(), &summary);
  failed_ = summary.termination_type == ceres::FAILURE;
  state_.poses = problem_.tried();
  const BodyCosts whole = energy_.bodyCosts (state_);
  keepGains (before, whole);
  BodyCosts now = energy_.bodyCosts (state_);
  if (whole.total < now.total) { // bodies that are tied gain together
    state_.poses = problem_.tried();
    energy_.level().sweep (state_, DataTerm::Pass::Linearize);
    now = whole;
  }
  converged_ = hardlyMoved (before);
  if (!(now.total < costs_.total)) {
    goBack (before);
    return false;
  }
  energy_.relaxWeights (state_);
  costs_ = now;
  return true;
}

/** All bodies, which are trusted less far. */
void
JointDescent::goBack (const WindowState& before)
{
  state_ = before;
  for (int b = 0; b < state_.bodies(); ++b) {
    energy_.level().recallSums (energy_.segmentsOf (b));
    for (StepReach& reach : reach_)
      reach.learn (b, false);
  }
}

/** |dx| <= tolerance |x|, as Ceres' criterion. */
bool
JointDescent::hardlyMoved (const WindowState& before) const
{
  double change = 0.0;
  double size = 0.0;
  for (std::size_t p = 0; p < state_.poses.size(); ++p)
    for (std::size_t b = 0; b < state_.poses[p].size(); ++b)
      for (int i = 0; i < 6; ++i) {
        const double x = before.poses[p][b].parameters[i];
        change += std::pow (state_.poses[p][b].parameters[i] - x, 2);
        size += x * x;
      }
  return std::sqrt (change) <=
         parameter_tolerance_ * (std::sqrt (size) + parameter_tolerance_);
}

/** Bodies whose cost has not fallen, or is not a number, go back. */
void
JointDescent::keepGains (const WindowState& before, const BodyCosts& tried)
{
  for (int b = 0; b < state_.bodies(); ++b) {
    const bool gained = tried.of[b] <= costs_.of[b];
    for (StepReach& reach : reach_)
      reach.learn (b, gained);
    if (gained)
      continue;
    for (std::size_t p = 0; p < state_.poses.size(); ++p)
      if (!state_.poses[p].empty())
        state_.poses[p][b] = before.poses[p][b];
    energy_.level().recallSums (energy_.segmentsOf (b));
  }
}

} // namespace pcl_msf
