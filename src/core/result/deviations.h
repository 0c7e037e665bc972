// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/instruction_set.h"
#include "core/base/tuning/result_tuning.h"
#include "core/segments/segment_pixels.h"
#include <pcl_msf/scene_flow.h>

#include <vector>

namespace pcl_msf {

/** \brief Fills in the standard deviation of each point's flow and displacement: of its
 * segment's pose, carried to the point, of its own depth, and of what a depth step
 * nearby makes uncertain; see SceneFlow. All instruction sets give the same bits.
 * \param covariances of the segments' pose parameters
 * \param camera of the current frame
 * \param inverse_depth_noise standard deviation, 1 / metres
 * \param result with poses, points, displacement, flow and visibility */
void
fillDeviations (const SegmentPixels& pixels,
                const std::vector<Matrix6>& covariances,
                const PinholeCamera& camera,
                double inverse_depth_noise,
                const DeviationTuning& tuning,
                int threads,
                SceneFlow& result,
                InstructionSet set = chosenInstructionSet());

} // namespace pcl_msf
