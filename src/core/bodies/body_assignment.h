// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/body_tuning.h"
#include "core/data/pair_terms.h"
#include "core/motion/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief Lets segments change to another body's motion where their points do not
 * object: what finds the way home for segments that were lost, hidden or too small.
 *
 * A segment tries its neighbours' bodies and the largest ones. It takes the one with
 * the lowest mean truncated cost per residual plus `separation` times the share of its
 * links, by their strength, that lead to other bodies. All decide at once, so that the
 * outcome does not depend on the order. Bodies without segments disappear. A place that
 * most of a segment's points would take from a larger body costs up to a conflict more
 * (ClaimMap). In a window only the pairs from the reference are asked: the points of
 * the others are where the present motion put them. \return how many changed */
int
reassignBodies (const std::vector<PairTerms>& terms,
                const std::vector<SegmentLink>& links,
                const AssignmentTuning& tuning,
                int threads,
                WindowState& state);

} // namespace pcl_msf
