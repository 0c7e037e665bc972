// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/minimize.h"

#include "core/energy/joint_descent.h"

#include <cmath>

namespace pcl_msf {

bool
SolveOutcome::settled (double share) const
{
  const double change = initial.total() - final.total();
  return iterations > 0 && !failed &&
         (converged || std::abs (change) < share * initial.total());
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
  monitor.noteTerms (outcome.initial);
  JointDescent descent (energy, solver, state);
  bool go_on = !monitor.stopped();
  while (go_on && outcome.iterations < solver.max_iterations) {
    const double before = descent.cost();
    const bool lower = descent.step (monitor.secondsLeft());
    ++outcome.iterations;
    outcome.failed = descent.failed();
    outcome.converged =
        lower && (descent.converged() ||
                  before - descent.cost() <= solver.function_tolerance * before);
    if (lower)
      monitor.noteTerms (energy.presentCost (state));
    go_on = monitor.step (descent.cost()) && !outcome.converged && !outcome.failed;
  }
  energy.level().completeSums();
  outcome.final = energy.evaluate (state);
  return outcome;
}

} // namespace pcl_msf
