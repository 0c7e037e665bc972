// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data_term.h"
#include "core/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief Segments of which next to nothing is seen in the current frame take the
 * motion of the linked segment that is seen and that their points object to least, the
 * nearest one when they object to none: what is left of their own motion says nothing.
 * \param data linearized at the state
 * \return how many changed */
int
followNeighbors (const DataTerm& data,
                 const std::vector<SegmentLink>& links,
                 MotionState& state);

} // namespace pcl_msf
