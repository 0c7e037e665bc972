// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuning.h"
#include "core/points/point_clouds.h"
#include "core/surface/surface_segments.h"

#include <vector>

namespace pcl_msf {

/** \brief A cut of the source's surface, and how its samples see it. */
struct SampleCut {
  SurfaceSegments segments;
  std::vector<int> seeds;                       ///< per segment, the sample at its seed
  std::vector<int> label;                       ///< per sample
  std::vector<std::vector<Membership>> members; ///< per sample
};

/** \brief The cuts of a source, coarse to fine: all but the last are only for the
 * samples, and made of them; the last one is of all points. Given segments are the only
 * cut.
 * \param fixed per given segment; empty = none is */
std::vector<SampleCut>
cutSamples (const WorkingCloud& cloud,
            const std::vector<char>& fixed,
            const Tuning& tuning);

} // namespace pcl_msf
