// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/window_tuning.h"

namespace pcl_msf {

void
listValues (WindowTuning& tuning, TunedValues& values)
{
  const TunedValues own{
      {"window.centroid_samples", &tuning.centroid_samples, 1, 1e6},
      {"window.falloff.rounds", &tuning.falloff.rounds, 1, 100},
      {"window.falloff.inlier", &tuning.falloff.inlier, 1e-6, 1},
      {"window.falloff.least_evidence", &tuning.falloff.least_evidence, 1e-9, 1e6},
      {"window.falloff.samples", &tuning.falloff.samples, 1, 1e6},
      {"window.carrier.relative_tolerance", &tuning.carrier.relative_tolerance, 0, 1},
      {"window.carrier.sigmas", &tuning.carrier.sigmas, 0, 1000},
      {"window.carrier.gap_rounds", &tuning.carrier.gap_rounds, 0, 100},
      {"window.fusion.sigmas", &tuning.fusion.sigmas, 0, 1000},
      {"window.fusion.model_share", &tuning.fusion.model_share, 0, 1}};
  values.insert (values.end(), own.begin(), own.end());
}

} // namespace pcl_msf
