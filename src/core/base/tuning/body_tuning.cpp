// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/body_tuning.h"

namespace pcl_msf {

void
listValues (BodyTuning& tuning, TunedValues& values)
{
  MergeTuning& merging = tuning.merging;
  AssignmentTuning& assignment = tuning.assignment;
  LandingTuning& landings = assignment.landings;
  const TunedValues own{
      {"bodies.merging.allowance", &merging.allowance, 0, 1e6},
      {"bodies.merging.per_point", &merging.per_point, 0, 1e3},
      {"bodies.merging.largest", &merging.largest, 0, 1000},
      {"bodies.assignment.separation", &assignment.separation, 0, 100},
      {"bodies.assignment.window_separation", &assignment.window_separation, 0, 100},
      {"bodies.assignment.flow_worth", &assignment.flow_worth, 0, 1000},
      {"bodies.assignment.prior", &assignment.prior, 0, 1e9},
      {"bodies.assignment.most_prior", &assignment.most_prior, 0, 100},
      {"bodies.assignment.rounds", &assignment.rounds, 0, 100},
      {"bodies.assignment.largest", &assignment.largest, 1, 1000},
      {"bodies.assignment.least_share", &assignment.least_share, 0, 1},
      {"bodies.assignment.mostly_hidden", &assignment.mostly_hidden, 0, 1},
      {"bodies.assignment.border_share", &assignment.border_share, 0, 0.99},
      {"bodies.assignment.landings.cell", &landings.cell, 1, 100},
      {"bodies.assignment.landings.per_segment", &landings.per_segment, 1, 1e6},
      {"bodies.assignment.landings.looks_alike", &landings.looks_alike, 0, 1000},
      {"bodies.assignment.landings.worse", &landings.worse, 0, 1000},
      {"bodies.hidden.hidden", &tuning.hidden.hidden, 0, 1},
      {"bodies.hidden.seen", &tuning.hidden.seen, 0, 1}};
  values.insert (values.end(), own.begin(), own.end());
}

} // namespace pcl_msf
