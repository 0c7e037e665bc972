// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/segment_tuning.h"
#include "core/motion/motion_state.h"
#include <pcl_msf/rgbd_frame.h>

#include <vector>

namespace pcl_msf {

/** \brief Makes links along a surface strong and all others weak.
 *
 * A link's strength is the share of the two segments' common border over which the
 * depth goes on without a step, and a small number where they touch nowhere or at a
 * step: a person is held together and does not drag the wall behind. Strengths are
 * scaled to a mean of one, so that all links together cost what equal ones would.
 * \param labels of the level \param inverse_depth_noise standard deviation, 1 / metres
 */
void
weighLinksBySurface (const cv::Mat& labels,
                     const FrameLevel& level,
                     double inverse_depth_noise,
                     const SegmentTuning& tuning,
                     std::vector<SegmentLink>& links);

} // namespace pcl_msf
