// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/solve_tuning.h"

namespace pcl_msf {

void
listValues (SolveTuning& tuning, TunedValues& values)
{
  NoiseTuning& noise = tuning.noise;
  StepTuning& step = tuning.step;
  const TunedValues own{
      {"solve.noise.least_intensity", &noise.least_intensity, 1e-6, 1},
      {"solve.noise.model_error", &noise.model_error, 0, 100},
      {"solve.noise.relative_depth", &noise.relative_depth, 0, 1},
      {"solve.noise.brightness_area", &noise.brightness_area, 1, 1e6},
      {"solve.noise.icp_area", &noise.icp_area, 1, 1e6},
      {"solve.step.reach", &step.reach, 1e-3, 1e3},
      {"solve.step.shrink", &step.shrink, 1e-3, 1},
      {"solve.step.grow", &step.grow, 1, 100},
      {"solve.step.least", &step.least, 1e-6, 1},
      {"solve.coarsest_level", &tuning.coarsest_level, 0, 10},
      {"solve.spreads", &tuning.spreads, 0, 100},
      {"solve.enough_jumps", &tuning.enough_jumps, 0, 1},
      {"solve.start_level", &tuning.start_level, 0, 10},
      {"solve.spread_share", &tuning.spread_share, 0.05, 10.0},
      {"solve.later_iterations", &tuning.later_iterations, 1, 1000},
      {"solve.finest_iterations", &tuning.finest_iterations, 1, 1000},
      {"solve.align_level", &tuning.align_level, 0, 10},
      {"solve.more_cost", &tuning.more_cost, 0, 100},
      {"solve.most_lost", &tuning.most_lost, 0, 1},
      {"solve.settled", &tuning.settled, 1e-9, 1},
      {"solve.tolerance_share", &tuning.tolerance_share, 1e-6, 1}};
  values.insert (values.end(), own.begin(), own.end());
}

} // namespace pcl_msf
