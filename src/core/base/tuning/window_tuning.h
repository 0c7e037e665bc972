// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

// Values of windows of more than two frames, chosen on generated ones of seeds 1 and 3.

/** \brief How a camera gets darker towards its corners. */
struct FalloffTuning {
  int rounds{3};              ///< of leaving out what does not fit; more is slower
  double inlier{0.02};        ///< intensity: a larger misfit counts less: more lets
                              ///< shadows in
  double least_evidence{0.1}; ///< holds the falloff at zero where little tells
  int samples{64};            ///< points per segment; more is slower
};

/** \brief Segments carried to other frames. */
struct CarrierTuning {
  double relative_tolerance{0.01}; ///< of the inverse depth: points on one surface, a
                                   ///< pixel apart: more carries labels
                                   ///< over edges, less leaves holes
  double sigmas{5.0};              ///< and standard deviations of its noise: likewise
  int gap_rounds{2};               ///< pixels of gaps that are closed, from both sides:
                                   ///< more closes what is uncovered
};

/** \brief The depth of all frames in one; see "Depth fused over the window" in
 * DECISIONS.md. */
struct FusionTuning {
  float sigmas{3.0f}; ///< standard deviations of two depths, beyond which a frame
                      ///< sees something else: more averages over edges
  float model_share{0.0005f}; ///< of the inverse depth: what poses and interpolation
                              ///< add: more trusts other frames less
};

struct WindowTuning {
  FalloffTuning falloff;
  CarrierTuning carrier;
  FusionTuning fusion;
  int centroid_samples{64}; ///< points of a segment that its centroid is taken of; more
                            ///< is slower
};

void
listValues (WindowTuning& tuning, TunedValues& values);

} // namespace pcl_msf
