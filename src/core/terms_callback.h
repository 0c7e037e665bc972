// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/joint_solver.h"
#include <ceres/iteration_callback.h>

namespace pcl_msf {

/** \brief Tells the monitor the energy by term after each iteration. Stands before the
 * callback that records the iteration; Ceres must update the state first
 * (update_state_every_iteration). */
class TermsCallback : public ceres::IterationCallback {
public:
  TermsCallback (SolveMonitor& monitor,
                 const JointEnergy& energy,
                 const MotionState& state)
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
  const JointEnergy& energy_;
  const MotionState& state_;
};

} // namespace pcl_msf
