// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/tuning/window_tuning.h"
#include "core/motion/motion_state.h"
#include "core/segments/segment_pixels.h"
#include <pcl_msf/rgbd_frame.h>

namespace pcl_msf {

/** \brief Labels of another frame: the reference's segments carried there by their
 * poses, with a z-buffer (the pairs of section 3.1 whose first frame is not the
 * reference).
 *
 * A pixel bears a segment's label when the segment's nearest point there lies on the
 * frame's own surface, within the noise; gaps of a pixel or two on one surface, as
 * expansion leaves them, are closed. Pixels that the reference does not show bear -1.
 * \param reference, frame of one level
 * \param labels of the reference, CV_32SC1
 * \param motion poses to the frame
 * \return CV_32SC1 of the frame's size */
cv::Mat
carryLabels (const FrameLevel& reference,
             const cv::Mat& labels,
             const MotionState& motion,
             const FrameLevel& frame,
             const NoiseModel& noise,
             const CarrierTuning& tuning);

} // namespace pcl_msf
