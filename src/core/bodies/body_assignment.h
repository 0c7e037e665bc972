// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/body_tuning.h"
#include "core/data/pair_terms.h"
#include "core/motion/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief What is assumed of the scene when segments change bodies. */
struct AssignmentRules {
  bool window{false};     ///< more than two frames: leaving all neighbours costs less
  bool background{false}; ///< the largest body stands still: leaving it always costs as
                          ///< much as it can
  bool hides{false};      ///< the largest body may hide segments: that needs no
                          ///< neighbour that is seen and is no evidence against it. Not
                          ///< where motions come from earlier frames, which saw them
};

/** \brief Assigns segments to the body whose motion fits them best: what corrects
 * segments that were lost, hidden or too small.
 *
 * Candidates are the bodies of the linked segments and the largest ones. A segment is
 * assigned to the one with the lowest mean truncated cost per residual plus
 * `separation` times the share of its links, by their strength, to segments of other
 * bodies. All are assigned at once, so that the outcome does not depend on the order.
 * Bodies without segments disappear. What would be hidden or out of view costs as much
 * as a conflict unless a neighbour that is seen moves likewise. Where most of a
 * segment's points would land on the place of a larger body that does not fit there
 * clearly worse, up to a conflict is added (LandingMap). In a window only the pairs
 * from the reference count: the points of the others are where the present motion put
 * them. \return how many changed */
int
reassignBodies (const std::vector<PairTerms>& terms,
                const std::vector<SegmentLink>& links,
                const AssignmentTuning& tuning,
                const AssignmentRules& rules,
                int threads,
                WindowState& state);

} // namespace pcl_msf
