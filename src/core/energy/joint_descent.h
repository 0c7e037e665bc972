// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/ceres_problem.h"
#include "core/energy/solve_monitor.h"
#include "core/energy/step_reach.h"
#include <ceres/solver.h>
#include <pcl_msf/parameters.h>

#include <vector>

namespace pcl_msf {

/** \brief Minimizes the energy (section 3.2) by joint steps, which Ceres computes for
 * all bodies together. A body takes its part of a step when that lowers what the energy
 * says of it, its data terms and what ties it to others; else it stays, and is trusted
 * less far. All take the step when that is better. So bodies that are lost do not hold
 * up those that are found; see "Each body takes its part of a step" in DECISIONS.md. */
class JointDescent {
public:
  /** \param state linearized by the energy; changed by each step */
  JointDescent (Energy& energy, const SolverParameters& solver, WindowState& state);

  /** \brief One step. \return did it lower the energy? Otherwise the state is as it
   * was.
   */
  bool
  step (double seconds_left);

  double
  cost () const
  {
    return costs_.total;
  }
  bool
  failed () const
  {
    return failed_;
  }
  /** \brief The last step changed the poses by less than the parameter tolerance. */
  bool
  converged () const
  {
    return converged_;
  }

private:
  void
  keepGains (const WindowState& before, const BodyCosts& tried);
  void
  goBack (const WindowState& before);
  bool
  hardlyMoved (const WindowState& before) const;

  Energy& energy_;
  WindowState& state_;
  std::vector<StepReach> reach_; ///< per used pair
  CeresProblem problem_;
  ceres::Solver::Options options_;
  double parameter_tolerance_;
  BodyCosts costs_; ///< at the state
  bool failed_{false};
  bool converged_{false};
};

} // namespace pcl_msf
