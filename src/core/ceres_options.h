// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/solve_monitor.h"
#include <ceres/iteration_callback.h>
#include <ceres/solver.h>
#include <pcl_msf/parameters.h>

namespace pcl_msf {

/** \brief Passes iterations on and ends the solve when the monitor says so. */
class MonitorCallback : public ceres::IterationCallback {
public:
  explicit MonitorCallback (SolveMonitor& monitor) : monitor_ (monitor) {}

  ceres::CallbackReturnType
  operator() (const ceres::IterationSummary& summary) override
  {
    if (summary.iteration == 0)
      return monitor_.stopped() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                : ceres::SOLVER_CONTINUE;
    return monitor_.step (summary.cost) ? ceres::SOLVER_CONTINUE
                                        : ceres::SOLVER_TERMINATE_SUCCESSFULLY;
  }

private:
  SolveMonitor& monitor_;
};

/** \brief How Ceres minimizes Eq. 5 and Eq. 13 (section 3.2). */
ceres::Solver::Options
ceresOptions (const SolverParameters& solver, const SolveMonitor& monitor);

} // namespace pcl_msf
