// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/start_tuning.h"
#include "core/motion/rigid_fit.h"
#include "core/start/flow_hypotheses.h"
#include <pcl_msf/rgbd_frame.h>

#include <vector>

namespace pcl_msf {

/** \brief Places of the reference that look like one of the current frame, wherever it
 * lies: image features (SIFT) that are each other's best match and clearly better than
 * the second best. Only those with depth in the reference. */
std::vector<FlowSample>
matchFeatures (const RgbdFrame& reference,
               const RgbdFrame& current,
               const FarMotionTuning& tuning,
               int threads);

/** \brief Rigid motions that many matches agree on, the best supported first: fits to
 * each match with those nearest to it in space, of which the best is refined; then the
 * best for the matches that are left, and so on. Wrong matches agree on nothing. */
std::vector<RigidPose>
motionsOfMatches (const std::vector<FlowSample>& matches,
                  const RigidPose& start,
                  const RigidFitOptions& options,
                  const FarMotionTuning& tuning,
                  int threads);

/** \brief Motions farther than optical flow reaches. */
struct FarMotions {
  std::vector<RigidPose> motions;
  bool instead_of_flow{false}; ///< most matches contradict the flow: it has failed
};

/** \brief Motions of the matched features that optical flow missed. */
FarMotions
findFarMotions (const RgbdFrame& reference,
                const RgbdFrame& current,
                const CoarseFlow& flow,
                const RigidPose& start,
                const RigidFitOptions& options,
                const FarMotionTuning& tuning,
                int threads);

} // namespace pcl_msf
