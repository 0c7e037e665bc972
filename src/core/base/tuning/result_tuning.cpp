// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/result_tuning.h"

namespace pcl_msf {

namespace {

void
listRefinement (RefinementTuning& refinement, TunedValues& values)
{
  const TunedValues own{
      {"result.refinement.common", &refinement.common, 0, 1},
      {"result.refinement.tile", &refinement.tile, 16, 100000},
      {"result.refinement.most_spread", &refinement.most_spread, 0, 10000},
      {"result.refinement.margin", &refinement.margin, 1, 1000},
      {"result.refinement.better", &refinement.better, 0, 1},
      {"result.refinement.window", &refinement.window, 0.3, 100},
      {"result.refinement.most_residual", &refinement.most_residual, 1e-3, 1},
      {"result.refinement.clearly", &refinement.clearly, 0, 1},
      {"result.refinement.smoothness", &refinement.smoothness, 0.01, 1e4},
      {"result.refinement.brightness", &refinement.brightness, 0, 1e4},
      {"result.refinement.gradient", &refinement.gradient, 0, 1e4},
      {"result.refinement.iterations", &refinement.iterations, 1, 100},
      {"result.refinement.relaxations", &refinement.relaxations, 1, 100}};
  values.insert (values.end(), own.begin(), own.end());
}

} // namespace

void
listValues (ResultTuning& tuning, TunedValues& values)
{
  SoftTuning& soft = tuning.soft;
  VisibilityTuning& visibility = tuning.visibility;
  OutcomeTuning& outcome = tuning.outcome;
  InformationTuning& information = tuning.information;
  DeviationTuning& deviation = tuning.deviation;
  const TunedValues own{
      {"result.status.seen_enough", &tuning.status.seen_enough, 0, 1},
      {"result.status.rank_share", &tuning.status.rank_share, 0, 1},
      {"result.status.connected", &tuning.status.connected, 0, 1},
      {"result.blend.least_strength", &tuning.blend.least_strength, 0, 1},
      {"result.blend.reach", &tuning.blend.reach, 0.01, 100},
      {"result.soft.samples", &soft.samples, 1, 1e6},
      {"result.soft.least_samples", &soft.least_samples, 1, 1e6},
      {"result.soft.near", &soft.near, 0, 0.5},
      {"result.soft.far", &soft.far, 0.5, 1},
      {"result.soft.clear", &soft.clear, 0, 100},
      {"result.groups.together", &tuning.groups.together, 0, 1},
      {"result.groups.soft", &tuning.groups.soft, 0, 1},
      {"result.groups.small_body", &tuning.groups.small_body, 0, 1e6},
      {"result.visibility.most_widening", &visibility.most_widening, 1, 1000},
      {"result.visibility.most_share", &visibility.most_share, 1e-4, 1},
      {"result.visibility.samples", &visibility.samples, 1, 1e7},
      {"result.visibility.surface", &visibility.surface, 0, 9},
      {"result.outcome.few_points", &outcome.few_points, 0, 1e6},
      {"result.outcome.few", &outcome.few, 0, 1},
      {"result.outcome.hardly_any", &outcome.hardly_any, 0, 1},
      {"result.outcome.mostly", &outcome.mostly, 0, 1},
      {"result.outcome.no_surface", &outcome.no_surface, 0, 100},
      {"result.outcome.least_contrast", &outcome.least_contrast, 0, 1},
      {"result.outcome.significant", &outcome.significant, 0, 1000},
      {"result.outcome.patch", &outcome.patch, 3, 100},
      {"result.outcome.patch_seen", &outcome.patch_seen, 2, 1e4},
      {"result.outcome.patches", &outcome.patches, 1, 1e6},
      {"result.outcome.same_place", &outcome.same_place, -1, 1},
      {"result.outcome.found", &outcome.found, 0, 1},
      {"result.outcome.in_front", &outcome.in_front, 0, 1},
      {"result.outcome.few_found", &outcome.few_found, 0, 1},
      {"result.outcome.near", &outcome.near, 0, 1},
      {"result.information.tiles", &information.tiles, 1, 1e6},
      {"result.information.enough_tiles", &information.enough_tiles, 2, 1e6},
      {"result.information.least_tile", &information.least_tile, 1, 1000},
      {"result.information.smaller", &information.smaller, 1.01, 10},
      {"result.information.pooled", &information.pooled, 0, 1e6},
      {"result.information.reach", &information.reach, 0.1, 1e4},
      {"result.information.elsewhere", &information.elsewhere, 0, 1},
      {"result.information.most_extra", &information.most_extra, 1e-3, 100},
      {"result.information.not_found", &information.not_found, 0, 1},
      {"result.information.own", &information.own, 0, 1},
      {"result.deviation.near_step", &deviation.near_step, 1, 100},
      {"result.deviation.far_step", &deviation.far_step, 1, 100},
      {"result.deviation.far_weight", &deviation.far_weight, 0, 1},
      {"result.deviation.across", &deviation.across, 0, 1},
      {"result.deviation.across_unseen", &deviation.across_unseen, 0, 1},
      {"result.deviation.least_pixels", &deviation.least_pixels, 1e-6, 1}};
  values.insert (values.end(), own.begin(), own.end());
  listRefinement (tuning.refinement, values);
}

} // namespace pcl_msf
