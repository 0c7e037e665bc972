// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/body_tuning.h"
#include "core/data/pair_terms.h"
#include "core/motion/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief Assigns segments of which next to nothing is visible in the other frames to
 * the body of a linked segment that is visible: the one whose motion costs least, the
 * nearest one when several cost the same. The few residuals left do not determine a
 * motion of their own. Only pairs from the reference count. \param terms linearized at
 * the state \return how many changed */
int
assignHiddenSegments (const std::vector<PairTerms>& terms,
                      const std::vector<SegmentLink>& links,
                      const HiddenTuning& tuning,
                      WindowState& state);

} // namespace pcl_msf
