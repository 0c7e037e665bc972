// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include "core/data/data_term.h"
#include "core/motion/motion_state.h"
#include <pcl_msf/scene_flow.h>

#include <vector>

namespace pcl_msf {

/** \brief Fills in the segments' motions, rank, status, and the bodies.
 * \param residual_scale energy times this = sum of 1/2 (residual / sigma)^2 */
void
fillSegments (const DataTerm& data,
              const std::vector<SegmentLink>& links,
              const MotionState& state,
              double residual_scale,
              const ResultTuning& tuning,
              int threads,
              SceneFlow& result);

} // namespace pcl_msf
