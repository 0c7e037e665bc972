// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/points/rigid_moments.h"
#include "core/surface/surface_segments.h"

#include <vector>

namespace pcl_msf {

/** \brief A body that is free along a direction is held there by those that it touches:
 * the sides of a limb without an end do not tell how far along it has moved.
 * \param poses, rigid per part
 * \param[in,out] moments per part: of its pulls, with what holds it after */
void
holdSeams (const std::vector<SurfaceSeam>& seams,
           const std::vector<RigidPose>& poses,
           const std::vector<char>& rigid,
           const PointPartTuning& tuning,
           std::vector<RigidMoments>& moments);

} // namespace pcl_msf
