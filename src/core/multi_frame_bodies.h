// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/body_merging.h"
#include "core/multi_frame_level.h"
#include "core/multi_frame_state.h"

namespace pcl_msf {

/** \brief mergeBodies for a window: two bodies merge when, over all pairs together, one
 * common trajectory explains their points as well as two.
 * \param level linearized at the state
 * \param rules allowances, which grow with the root of the number of motions
 * from frame to frame; the residual scale is not used */
void
mergeTrajectories (const MultiFrameLevel& level,
                   const MultiFrameScene& scene,
                   const EnergyParameters& energy,
                   const MergeRules& rules,
                   MultiFrameState& state);

/** \brief How segments choose among bodies' trajectories. */
struct AssignmentRules {
  double separation; ///< mean cost per residual that leaving all neighbours costs
  double background; ///< mean cost that leaving the largest body costs; 0 = no prior
  int rounds;
};

/** \brief reassignBodies for a window. Only pairs from the reference are asked: the
 * points of the others are where the present trajectory put them. */
void
reassignTrajectories (const MultiFrameLevel& level,
                      const MultiFrameScene& scene,
                      const AssignmentRules& rules,
                      MultiFrameState& state);

} // namespace pcl_msf
