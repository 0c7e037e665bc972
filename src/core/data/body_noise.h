// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/pair_terms.h"
#include "core/motion/motion_state.h"
#include "core/segments/segment_pixels.h"

namespace pcl_msf {

/** \brief Measures how well large rigid bodies fit, and weighs their points by it.
 *
 * The noise model allows for what rigid segments leave unexplained on soft surfaces. A
 * body of many segments is truly rigid, so that its residuals show the noise alone:
 * both scales are divided by the median size of their residuals, if that is smaller
 * than the model says. \param terms of `pixels`, in pairs of frames that they start
 * \param pixels of one frame: the reference or one that segments were carried to */
void
rescaleBodyNoise (const std::vector<PairTerms>& terms,
                  const WindowState& state,
                  const BodyNoiseTuning& tuning,
                  int threads,
                  SegmentPixels& pixels);

} // namespace pcl_msf
