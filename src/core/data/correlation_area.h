// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/pair_terms.h"
#include "core/motion/motion_state.h"
#include "core/segments/segment_pixels.h"

#include <vector>

namespace pcl_msf {

/** \brief How many pixels are worth one independent residual, from what is left.
 *
 * A sensor that matches windows errs alike all over a window, and a camera's brightness
 * differs alike over a shadow: the sum of a tile's score vectors J' w r is then larger
 * than that of independent ones. The area is the ratio of both, the factor by which the
 * information matrix sum w J' J overstates what is known (the sandwich estimate of a
 * covariance, Huber 1967; with clusters, Liang and Zeger 1986). It holds the noise
 * model's wrong level, too: noise twice as strong as modelled counts as four times the
 * area.
 *
 * Tiles are the parts of one body in squares of some pixels of the full resolution. The
 * median over tiles, weighted by their information, leaves out those that fit badly:
 * bodies that are not rigid, wrong motions.
 * \param terms of the pairs; those from the reference count
 * \param level of the terms; areas are in pixels of level 0 and at least 1
 * \param before what is returned where too little is seen to tell */
CorrelationAreas
measureCorrelationAreas (const std::vector<PairTerms>& terms,
                         const WindowState& state,
                         int level,
                         const CorrelationAreas& before,
                         const CorrelationTuning& tuning,
                         int threads);

} // namespace pcl_msf
