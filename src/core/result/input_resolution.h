// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/frame_tuning.h"
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief Carries a result to all pixels of the input, of which the reference frame
 * shows each 2^finestLevel ()th.
 *
 * Each measured pixel moves as the frame's pixels around it that show the same surface:
 * by the weights of bilinear interpolation, and turned on by the segment's rotation
 * from their mean to the pixel's own point, which makes rigid motion exact. Where none
 * shows it, by the one nearest in depth. Labels, visibility and deviations are those of
 * the pixel that counts most; segments count their points anew. \param camera of the
 * other frame's input */
void
carryToInput (const RgbdFrame& reference,
              const PinholeCamera& camera,
              const FrameTuning& tuning,
              int threads,
              SceneFlow& result);

} // namespace pcl_msf
