// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

/** \brief What residuals are measured in before anything is measured; see "The model's
 * own error is part of the noise" and "Residuals count for what they are worth" in
 * DECISIONS.md. */
struct NoiseTuning {
  double least_intensity{
      0.005};               ///< standard deviation: more trusts depth more than colour
  double model_error{0.15}; ///< pixels that rigid segments leave unexplained: more
                            ///< makes large bodies absorb small motions
  double relative_depth{0.003}; ///< of the inverse depth, beside the noise: more
                                ///< trusts colour more than depth
  double brightness_area{20.0}; ///< pixels of level 0 that one residual is worth, until
                                ///< it is measured: more merges more at the start
  double icp_area{200.0};       ///< likewise, of depth
};

/** \brief How far a step goes; see "Each body takes its part of a step" in
 * DECISIONS.md. */
struct StepTuning {
  double reach{2.0};  ///< pixels of the level: more goes where images are not linear
  double shrink{0.3}; ///< factor after a step that a body lost by: less is slower
                      ///< where images are linear
  double grow{1.5};   ///< and after one that it gained by: more loses more steps
  double least{0.02}; ///< share of the reach: less stands still
};

/** \brief Values of the schedule; see "One energy, one schedule", "Bodies are found
 * twice above the finest level" and "A followed frame is first registered as a whole"
 * in DECISIONS.md. */
struct SolveTuning {
  NoiseTuning noise;
  StepTuning step;
  int coarsest_level{2}; ///< the first solve of two frames: more reaches farther, and
                         ///< small things are not seen there
  double spread_share{0.33}; ///< of the user's steps, after motions have spread there:
                             ///< more is slower
  int spreads{2}; ///< how often motions spread there from segment to segment;
                  ///< see "Motions spread at the coarsest level" in
                  ///< DECISIONS.md
  double enough_jumps{0.05}; ///< of the segments, for another solve: more is
                             ///< faster
  int start_level{1};        ///< poses are compared at half resolution; less is slower
  int later_iterations{3};   ///< of a round after the coarsest level's; more is slower
  int finest_iterations{
      2}; ///< of the finest level's first round, before its bodies; likewise
  int align_level{4};    ///< where a followed frame is first registered as a whole;
                         ///< more finds what jumps farther
  double more_cost{0.5}; ///< of a residual than in the last frame: a segment that
                         ///< is followed is lost; more keeps wrong motions
  double most_lost{0.5}; ///< share of segments that a predicted motion may leave
                         ///< unexplained: more takes a solve from the start
  double tolerance_share{0.1}; ///< of the user's tolerance, in a window: a pair alone
                               ///< changes a sum of pairs little; more ends earlier
  double settled{0.01};        ///< of the cost: a last solve that changes less has
                               ///< converged; more calls more results so
};

void
listValues (SolveTuning& tuning, TunedValues& values);

} // namespace pcl_msf
