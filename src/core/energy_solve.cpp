// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy_solve.h"

#include <cmath>

namespace pcl_msf {

namespace {

constexpr double kSettled = 0.01; // relative change of the last solve: none

} // namespace

bool
SolveOutcome::settled() const
{
  const double change = initial.total() - final.total();
  return iterations > 0 && !failed &&
         (converged || std::abs (change) < kSettled * initial.total());
}

} // namespace pcl_msf
