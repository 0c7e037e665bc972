// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include "core/data/data_term.h"
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief Says of every moved point whether the current frame shows it, see Visibility,
 * and counts the points of each segment and the visible ones.
 * \param p points of level 0, whose depth tolerances are used \param image of the
 * current frame \param result with segments, points and displacement */
void
fillVisibility (const SegmentPixels& p,
                const kernel::Image& image,
                const VisibilityTuning& tuning,
                int threads,
                SceneFlow& result);

} // namespace pcl_msf
