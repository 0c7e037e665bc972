// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include "core/motion/motion_state.h"
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief Numbers the motion groups by size, which is points that the current frame
 * sees, too, and finds the dominant motion: that of the largest rigid body in the
 * largest group. \param result with segments and pairs; gets
 * the segments' groups and the dominant motion */
void
numberGroups (const MotionState& state, const GroupTuning& tuning, SceneFlow& result);

} // namespace pcl_msf
