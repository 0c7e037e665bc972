// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data_term.h"
#include "core/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief How unequal two bodies' motions may be and still count as one. */
struct MergeRules {
  double residual_scale; ///< energy times this = sum of 1/2 (residual / sigma)^2
  double allowance;      ///< increase allowed per merge, in those units
  double per_point;      ///< further increase per point of the smaller body
};

/** \brief Joins bodies that move as one (the paper: updates only merge, never split).
 *
 * Agglomerative, along the links, then also with the few largest bodies, linked or not:
 * two bodies merge when the sum of their quadratics, minimized over one common pose,
 * lies no more than allowed above the sum of their own minima - a chi-square test on
 * their pose difference with their information matrices.
 * \param data linearized at the state
 * \return the state with merged bodies at the common poses */
MotionState
mergeBodies (const DataTerm& data,
             const std::vector<SegmentLink>& links,
             const MergeRules& rules,
             const MotionState& state);

} // namespace pcl_msf
