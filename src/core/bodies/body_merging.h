// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/body_tuning.h"
#include "core/data/pair_terms.h"
#include "core/motion/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief Joins bodies that move as one (the paper: updates only merge, never split).
 *
 * Agglomerative, along the links, then also with the few largest bodies, linked or not:
 * two bodies merge when the sum of their quadratics, minimized over one common pose per
 * pair of frames, lies no more than allowed above the sum of their own minima - a
 * chi-square test on their pose differences with their information matrices. Allowances
 * grow with the root of the number of motions, one less than the frames: pairs share
 * their frames' noise.
 * \param terms of the pairs of frames that take part; their poses in the merged state
 * are the common ones, other pairs keep those of one of the bodies
 * \param frames of the window, two or more */
void
mergeBodies (const std::vector<PairTerms>& terms,
             int frames,
             const std::vector<SegmentLink>& links,
             const MergeTuning& tuning,
             WindowState& state);

} // namespace pcl_msf
