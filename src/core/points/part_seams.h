// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/points/limb_sections.h"
#include "core/points/rigid_moments.h"

#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief Where bodies touch. */
struct BodySeams {
  const Surface& surface;
  std::vector<int> whole; ///< per point the body it goes with
  std::vector<SurfaceSeam> seams;
};

/** \param part per point \param body per part: is it one? */
inline BodySeams
seamsOfBodies (const Surface& surface,
               const std::vector<int>& part,
               const std::vector<char>& body)
{
  std::vector<int> whole;
  std::vector<SurfaceSeam> seams = bodySeams (surface, part, body, whole);
  return {surface, std::move (whole), std::move (seams)};
}

/** \brief A body that is free along a direction is held there by those that it touches:
 * the sides of a limb without an end do not tell how far along it has moved. Limbs turn
 * about their middle.
 * \param poses per part
 * \param[in,out] moments per part: of its pulls, with what holds it after */
void
holdSeams (const BodySeams& bodies,
           const std::vector<RigidPose>& poses,
           const PointPartTuning& tuning,
           std::vector<RigidMoments>& moments);

} // namespace pcl_msf
