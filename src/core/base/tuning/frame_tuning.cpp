// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/frame_tuning.h"

namespace pcl_msf {

void
listValues (FrameTuning& tuning, TunedValues& values)
{
  NormalTuning& normals = tuning.normals;
  BrightnessTuning& brightness = tuning.brightness;
  const TunedValues own{
      {"frame.normals.same_surface", &normals.same_surface, 1e-4, 1},
      {"frame.normals.noise_sigmas", &normals.noise_sigmas, 0, 100},
      {"frame.normals.steepest", &normals.steepest, 1e-3, 10},
      {"frame.normals.error", &normals.error, 1e-4, 1},
      {"frame.normals.max_radius", &normals.max_radius, 1, 16},
      {"frame.brightness.min_pairs", &brightness.min_pairs, 3, 1e6},
      {"frame.brightness.min_spread", &brightness.min_spread, 1e-4, 1},
      {"frame.brightness.rounds", &brightness.rounds, 1, 100},
      {"frame.brightness.inlier_mads", &brightness.inlier_mads, 1, 100},
      {"frame.brightness.term_prior", &brightness.term_prior, 1e-6, 10},
      {"frame.brightness.light_explained", &brightness.light_explained, 0, 1},
      {"frame.brightness.least_light", &brightness.least_light, 0, 1},
      {"frame.brightness.contrast_radius", &brightness.contrast_radius, 1, 1000},
      {"frame.same_surface", &tuning.same_surface, 1e-4, 1},
      {"frame.same_sigmas", &tuning.same_sigmas, 0, 100},
      {"frame.smallest_side", &tuning.smallest_side, 12, 10000}};
  values.insert (values.end(), own.begin(), own.end());
}

} // namespace pcl_msf
