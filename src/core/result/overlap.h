// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief How much of the reference another frame shows, counted in points. */
struct Overlap {
  int points{0};    ///< with depth
  int moved{0};     ///< of those, whose motion is known
  int landed{0};    ///< of those, in view and where the frame has depth
  int found{0};     ///< of those, visible
  int contrasts{0}; ///< of those, with contrast beyond the noise in both frames, or far
                    ///< beyond it in one
  int alike{0};     ///< of those, brighter or darker than around them in both
};

/** \brief Counts. Contrast is the difference to the mean of a few pixels around, which
 * exposure does not change; half of all contrasts are alike by chance.
 * \param flow with flow and visibility
 * \param intensity_noise standard deviation */
Overlap
measureOverlap (const RgbdFrame& reference,
                const RgbdFrame& current,
                double intensity_noise,
                const SceneFlow& flow);

} // namespace pcl_msf
