// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/window_tuning.h"
#include "core/frame/brightness_change.h"
#include "core/motion/motion_state.h"
#include "core/segments/segment_pixels.h"
#include <pcl_msf/rgbd_frame.h>

#include <vector>

namespace pcl_msf {

/** \brief Matches of the reference's points where the poses carry them and the frame
 * shows their surface. \param points of the reference, intensities unchanged
 * \param level of the frame, the points' size */
MatchedIntensities
matchIntensities (const SegmentPixels& points,
                  const MotionState& motion,
                  const FrameLevel& level);

/** \brief How a camera's images get darker towards their corners: the factor 1 + a r^2,
 * with r the tangent of the angle to the optical axis.
 *
 * Points that move across the image tell it; unnoticed it looks like motion. Robust;
 * 0 when nothing tells, and within [-0.6, 0.2] in any case.
 * \param matches per frame \param exposure per frame */
double
fitFalloff (const std::vector<MatchedIntensities>& matches,
            const std::vector<BrightnessChange>& exposure,
            const FalloffTuning& tuning);

/** \brief A level's intensity as the reference's exposure would have it, without
 * falloff. CV_32FC1; empty without intensity. */
cv::Mat
correctIntensity (const FrameLevel& level,
                  const BrightnessChange& exposure,
                  double falloff);

} // namespace pcl_msf
