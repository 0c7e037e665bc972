// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/energy.h"
#include "core/energy/solve_monitor.h"
#include <pcl_msf/parameters.h>

namespace pcl_msf {

/** \brief How a Ceres solve ended. */
struct SolveOutcome {
  EnergyCost initial;
  EnergyCost final;
  int iterations{0};
  bool converged{false};
  bool failed{false};

  /** \brief Ended well: by Ceres' criteria, or with next to no change.
   * \param share of the cost that counts as none */
  bool
  settled (double share) const;
};

/** \brief Minimizes the energy over a state's poses and weights (section 3.2), from
 * that state; correspondences are renewed after every successful step. The monitor
 * records the iterations and may end the solve. */
SolveOutcome
minimize (Energy& energy,
          const SolverParameters& solver,
          SolveMonitor& monitor,
          WindowState& state);

} // namespace pcl_msf
