// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include "core/data/data_term.h"
#include "core/motion/motion_state.h"

#include <vector>

namespace pcl_msf {

/** \brief What the frames show at the border between two segments. */
enum class LinkEvidence : char {
  None, ///< nothing: no texture, no shape, or equal motions
  Soft, ///< points between the centres move by a mixture of both motions
  Sharp ///< each side moves by its own motion alone
};

/** \brief Compares, per link between different bodies, the misfit of the points between
 * both centres when they move by their own segment's pose and by the mean of both poses
 * weighted by the distance. The lifting weights tell how far two motions differ; this
 * tells whether a soft surface bridges the difference.
 * \param data at the finest level, linearized at the state */
std::vector<LinkEvidence>
classifyLinks (const DataTerm& data,
               const std::vector<SegmentLink>& links,
               const MotionState& state,
               const SoftTuning& tuning,
               int threads);

} // namespace pcl_msf
