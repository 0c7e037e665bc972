// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/body_tuning.h"
#include "core/data/pair_terms.h"
#include "core/motion/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief Segments of which next to nothing is seen in the other frames take the
 * motion of the linked segment that is seen and that their points object to least, the
 * nearest one when they object to none: what is left of their own motion says nothing.
 * Only pairs from the reference tell. \param terms linearized at the state
 * \return how many changed */
int
followNeighbors (const std::vector<PairTerms>& terms,
                 const std::vector<SegmentLink>& links,
                 const HiddenTuning& tuning,
                 WindowState& state);

} // namespace pcl_msf
