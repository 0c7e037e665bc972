// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/deformation.h"
#include "core/points/point_clouds.h"

#include <vector>

namespace pcl_msf {

/** \brief Per point of a surface: is the nearest moved point within the distance, and
 * does it not face away? \param facing least cosine between their normals */
std::vector<char>
coveredPlaces (const Surface& surface,
               const MovedPoints& moved,
               double most,
               float facing,
               int threads);

/** \brief The largest piece of the target's surface, as a share of all, that the moved
 * source leaves bare though the source's own surface goes on at its rim: where that is
 * cut off, too, the piece has nothing to be covered by; where it is not, it went
 * elsewhere, as when a limb ends on another one.
 * \param samples the source's thin surface, moved \param covered per sample of the
 * target \param reach median spacings that points may be from the border of a cut */
double
largestLooseEnd (const PointClouds& clouds,
                 const std::vector<Eigen::Vector3f>& samples,
                 const std::vector<char>& covered,
                 double reach);

/** \brief How far neighbouring segments are from each other where they touch, mean, in
 * radii of a segment: joints turn without that, a torn or twisted surface does not. */
double
meanGap (const SurfaceSegments& segments, const std::vector<RigidPose>& poses);

/** \brief Per point, the mean ratio by which the distances to its neighbours along the
 * surface have changed, more 1: 0 where it moved rigidly. */
std::vector<float>
stretchOf (const Surface& surface,
           const std::vector<Eigen::Vector3f>& moved,
           int threads);

} // namespace pcl_msf
