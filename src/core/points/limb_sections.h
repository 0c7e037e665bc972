// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/surface/surface_segments.h"

#include <vector>

namespace pcl_msf {

/** \brief The seams between bodies as if scraps between them were not there: these go
 * with the body that is next to them along the surface, else a joint that a scrap fills
 * on one side would seem to lie on the other one.
 * \param part per point \param body per part: is it one?
 * \param[out] whole per point the body it goes with, -1 = on a piece without one */
std::vector<SurfaceSeam>
bodySeams (const Surface& surface,
           const std::vector<int>& part,
           const std::vector<char>& body,
           std::vector<int>& whole);

/** \brief Middle of the cross-section that a limb has beside a seam, and as far along
 * the limb as the seam: where the border is drawn there, and how densely points lie,
 * does not matter.
 * \param whole per point the body it goes with
 * \param along direction of the limb, unit
 * \return the seam's own centre where the limb is no tube there */
Eigen::Vector3d
sectionCenter (const Surface& surface,
               const std::vector<int>& whole,
               int limb,
               const SurfaceSeam& seam,
               const Eigen::Vector3d& along,
               const LimbSectionTuning& tuning);

} // namespace pcl_msf
