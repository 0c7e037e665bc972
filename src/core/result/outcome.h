// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow.h>

#include <string>
#include <vector>

// What success means, for two frames, windows and tracking alike.

namespace pcl_msf {

/** \brief What the motion from the reference to one frame is worth. */
struct Judgement {
  StopReason failure{StopReason::NotRun}; ///< NothingDetermined, DifferentPlaces, or
                                          ///< NotRun: none
  std::string why;                        ///< for a person
  int frame{-1};                          ///< of the window, -1: there are two
};

/** \brief How a solve ended that nobody cut short. */
StopReason
endOfSolve (bool settled, bool failed);

/** \brief Judges a motion by what is known of it and how much of the reference it finds
 * in the other frame. When that is nothing, the motion is made unknown as a whole.
 * \param flow complete but for its report
 * \param intensity_noise standard deviation */
Judgement
judgeMotion (const RgbdFrame& reference,
             const RgbdFrame& current,
             double intensity_noise,
             const OutcomeTuning& tuning,
             int threads,
             SceneFlow& flow);

/** \brief Stop reason, flag and message of a report, so that they agree.
 * \param cut_short by time or the user; NotRun: by neither
 * \param report its stop_reason is the solve's own end */
void
conclude (StopReason cut_short,
          const std::vector<Judgement>& judgements,
          Report& report);

} // namespace pcl_msf
