// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/surface_tuning.h"

namespace pcl_msf {

void
listValues (SurfaceTuning& tuning, TunedValues& values)
{
  const TunedValues own{{"surface.neighbors", &tuning.neighbors, 4, 100},
                        {"surface.near", &tuning.near, 1, 100},
                        {"surface.reach", &tuning.reach, 1, 100},
                        {"surface.facing", &tuning.facing, -1, 1},
                        {"surface.steep", &tuning.steep, 0, 1},
                        {"surface.leap", &tuning.leap, 0, 1},
                        {"surface.border_gap", &tuning.border_gap, 0.5, 6.3},
                        {"surface.small_piece", &tuning.small_piece, 0, 1000},
                        {"surface.dust_far", &tuning.dust_far, 1, 1000},
                        {"surface.dust_loose", &tuning.dust_loose, 1, 1000},
                        {"surface.dust_flat", &tuning.dust_flat, 0, 10},
                        {"surface.bridge_neighbors", &tuning.bridge_neighbors, 1, 1000},
                        {"surface.bridge_reach", &tuning.bridge_reach, 0, 100},
                        {"surface.members", &tuning.members, 1, 32},
                        {"surface.overlap", &tuning.overlap, 0.1, 10}};
  values.insert (values.end(), own.begin(), own.end());
}

} // namespace pcl_msf
