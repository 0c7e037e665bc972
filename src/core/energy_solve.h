// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/ceres_options.h"
#include "core/terms_callback.h"
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief How a Ceres solve ended. */
struct SolveOutcome {
  EnergyCost initial;
  EnergyCost final;
  int iterations{0};
  bool converged{false};
  bool failed{false};

  /** \brief Ended well: by Ceres' criteria, or with next to no change. */
  bool
  settled () const;
};

/** \brief Minimizes an energy over a state's poses and weights (section 3.2).
 *
 * `Energy` has relaxWeights, evaluate, which linearizes the data terms, and
 * presentCost; `Problem` makes a Ceres problem of both. Correspondences are renewed
 * after every successful step. */
template <typename Problem, typename Energy, typename State>
SolveOutcome
minimizeEnergy (Energy& energy,
                State& state,
                const SolverParameters& solver,
                SolveMonitor& monitor)
{
  SolveOutcome outcome;
  energy.relaxWeights (state);
  outcome.initial = energy.evaluate (state);
  Problem problem (energy, state);
  problem.startsLinearized();
  MonitorCallback callback (monitor);
  ceres::Solver::Options options = ceresOptions (solver, monitor);
  monitor.noteTerms (outcome.initial);
  TermsCallback terms (monitor, energy, state);
  options.update_state_every_iteration = true; // for the terms
  options.callbacks = {&terms, &callback};
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
