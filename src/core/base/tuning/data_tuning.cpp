// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/data_tuning.h"

namespace pcl_msf {

void
listValues (DataTuning& tuning, TunedValues& values)
{
  MissingTuning& missing = tuning.missing;
  CorrelationTuning& correlation = tuning.correlation;
  BodyNoiseTuning& body_noise = tuning.body_noise;
  const TunedValues own{
      {"data.probes", &tuning.probes, 1, 1e6},
      {"data.relative_tolerance", &tuning.relative_tolerance, 0, 1},
      {"data.finest_thinning", &tuning.finest_thinning, 1, 4},
      {"data.half_thinning", &tuning.half_thinning, 1, 4},
      {"data.least_thinned", &tuning.least_thinned, 1, 1e9},
      {"data.missing.wrong_match", &missing.wrong_match, 2.5, 100},
      {"data.missing.no_depth", &missing.no_depth, 0, 100},
      {"data.missing.occluded", &missing.occluded, 0, 4},
      {"data.missing.out_of_view", &missing.out_of_view, 0, 100},
      {"data.correlation.tile", &correlation.tile, 1, 1000},
      {"data.correlation.least_filled", &correlation.least_filled, 0, 1},
      {"data.correlation.least_tiles", &correlation.least_tiles, 1, 1e6},
      {"data.correlation.most_rows", &correlation.most_rows, 1, 1e6},
      {"data.body_noise.rigid", &body_noise.rigid, 1, 1e6},
      {"data.body_noise.samples", &body_noise.samples, 1, 1e7},
      {"data.body_noise.least_samples", &body_noise.least_samples, 1, 1e7},
      {"data.body_noise.most_brightness", &body_noise.most_brightness, 1, 1000},
      {"data.body_noise.most_icp", &body_noise.most_icp, 1, 1000}};
  values.insert (values.end(), own.begin(), own.end());
}

} // namespace pcl_msf
