// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/segment_tuning.h"

namespace pcl_msf {

void
listValues (SegmentTuning& tuning, TunedValues& values)
{
  ClusterTuning& clusters = tuning.clusters;
  const TunedValues own{
      {"segments.plane_share", &tuning.plane_share, 0, 1},
      {"segments.clusters.iterations", &clusters.iterations, 0, 100},
      {"segments.clusters.intensity_scale", &clusters.intensity_scale, 0, 1000},
      {"segments.clusters.plane_scale", &clusters.plane_scale, 0, 100},
      {"segments.clusters.plane_limit", &clusters.plane_limit, 0, 1e6},
      {"segments.clusters.outlier", &clusters.outlier, 0.1, 1e6},
      {"segments.connections.stop", &tuning.connections.stop, 0.1, 1e6},
      {"segments.connections.rounds", &tuning.connections.rounds, 0, 100},
      {"segments.links.step", &tuning.links.step, 0, 1e6},
      {"segments.links.apart", &tuning.links.apart, 1e-6, 1},
      {"segments.pixels.least_points", &tuning.pixels.least_points, 1, 1e6},
      {"segments.pixels.least_samples", &tuning.pixels.least_samples, 0, 1e7},
      {"segments.pixels.hidden_sigmas", &tuning.pixels.hidden_sigmas, 0.1, 1000}};
  values.insert (values.end(), own.begin(), own.end());
}

} // namespace pcl_msf
