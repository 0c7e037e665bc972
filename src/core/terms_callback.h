// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/solve_monitor.h"
#include <ceres/iteration_callback.h>

namespace pcl_msf {

/** \brief Tells the monitor the energy by term after each iteration. Stands before the
 * callback that records the iteration; Ceres must update the state first
 * (update_state_every_iteration). `Energy` has presentCost (State). */
template <typename Energy, typename State>
class TermsCallback : public ceres::IterationCallback {
public:
  TermsCallback (SolveMonitor& monitor, const Energy& energy, const State& state)
  : monitor_ (monitor), energy_ (energy), state_ (state)
  {}

  ceres::CallbackReturnType
  operator() (const ceres::IterationSummary& summary) override
  {
    if (summary.step_is_successful) // then the last sweep was at the new state
      monitor_.noteTerms (energy_.presentCost (state_));
    return ceres::SOLVER_CONTINUE;
  }

private:
  SolveMonitor& monitor_;
  const Energy& energy_;
  const State& state_;
};

} // namespace pcl_msf
