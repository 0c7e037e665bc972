// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/start_tuning.h"

namespace pcl_msf {

void
listValues (StartTuning& tuning, TunedValues& values)
{
  RigidFitTuning& fit = tuning.fit;
  ProposalTuning& proposals = tuning.proposals;
  FlowTuning& flow = tuning.flow;
  FlowEvidenceTuning& evidence = tuning.evidence;
  FarMotionTuning& far = tuning.far_motion;
  const TunedValues own{
      {"start.fit.smallest_scale", &fit.smallest_scale, 1e-3, 100},
      {"start.fit.iterations", &fit.iterations, 1, 100},
      {"start.fit.rotation_prior", &fit.rotation_prior, 0, 1e4},
      {"start.fit.depth_scale", &fit.depth_scale, 1e-3, 1000},
      {"start.fit.depth_weight", &fit.depth_weight, 0, 1000},
      {"start.fit.depth_share", &fit.depth_share, 0, 1000},
      {"start.proposals.own_penalty", &proposals.own_penalty, 0, 100},
      {"start.proposals.rough", &proposals.rough, 0, 100},
      {"start.proposals.mostly_hidden", &proposals.mostly_hidden, 0, 1},
      {"start.proposals.clearly_better", &proposals.clearly_better, 0, 1},
      {"start.proposals.first_rounds", &proposals.first_rounds, 0, 100},
      {"start.proposals.later_rounds", &proposals.later_rounds, 0, 100},
      {"start.flow.noise", &flow.noise, 0.01, 100},
      {"start.flow.min_samples", &flow.min_samples, 3, 1000},
      {"start.flow.max_bodies", &flow.max_bodies, 0, 100},
      {"start.flow.voters", &flow.voters, 1, 1000},
      {"start.flow.vote_limit", &flow.vote_limit, 0.01, 1000},
      {"start.flow.explained", &flow.explained, 0, 1},
      {"start.flow.smallest_body", &flow.smallest_body, 1e-4, 1},
      {"start.flow.quarter_width", &flow.quarter_width, 64, 1e6},
      {"start.flow.quarter_depth_width", &flow.quarter_depth_width, 64, 1e6},
      {"start.flow.quarter_height", &flow.quarter_height, 64, 1e6},
      {"start.evidence.samples", &evidence.samples, 1, 1000},
      {"start.evidence.sigma", &evidence.sigma, 0.01, 100},
      {"start.evidence.spread", &evidence.spread, 0, 100},
      {"start.evidence.cap", &evidence.cap, 0.1, 1000},
      {"start.evidence.solving", &evidence.solving, 0, 1000},
      {"start.evidence.proposing", &evidence.proposing, 0, 1000},
      {"start.far_motion.features", &far.features, 10, 1e6},
      {"start.far_motion.distinct", &far.distinct, 0.1, 1},
      {"start.far_motion.group", &far.group, 3, 1000},
      {"start.far_motion.most_groups", &far.most_groups, 1, 1e5},
      {"start.far_motion.min_matches", &far.min_matches, 3, 1000},
      {"start.far_motion.enough", &far.enough, 3, 1e6},
      {"start.far_motion.most_motions", &far.most_motions, 0, 100},
      {"start.far_motion.agree", &far.agree, 0.01, 1000},
      {"start.far_motion.explained", &far.explained, 0, 1},
      {"start.unexplained", &tuning.unexplained, 0, 100},
      {"start.lost", &tuning.lost, 0, 1},
      {"start.same_depth", &tuning.same_depth, 1e-4, 10}};
  values.insert (values.end(), own.begin(), own.end());
}

} // namespace pcl_msf
