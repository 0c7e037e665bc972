// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include "core/data/data_term.h"
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief Says of every moved point whether the current frame shows it, see Visibility,
 * and counts the visible points of each segment.
 * \param data of level 0, whose points and depth tolerances are used
 * \param result with segments, points and displacement */
void
fillVisibility (const DataTerm& data,
                const VisibilityTuning& tuning,
                int threads,
                SceneFlow& result);

} // namespace pcl_msf
