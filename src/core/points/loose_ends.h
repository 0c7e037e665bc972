// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/points/deformation.h"
#include "core/points/point_clouds.h"

#include <algorithm>
#include <vector>

namespace pcl_msf {

/** \brief A surface and where its points lie now. */
struct PlacedSurface {
  const Surface& surface;
  const std::vector<Eigen::Vector3f>& points;
};

/** \brief Pieces of a surface that another one leaves bare though its own surface goes
 * on at their rims, as shares of all: where that is cut off, too, a piece has nothing
 * to be covered by; where it is not, it went elsewhere, as when a limb ends on another.
 */
struct LooseEnds {
  double largest{0.0};
  double all{0.0}; ///< with pieces that have no rim
};

/** \brief Per place: is the nearest of other points within the distance, and does it
 * not face away? \param facing least cosine between their normals */
std::vector<char>
coveredPlaces (const MovedPoints& places,
               const MovedPoints& others,
               double most,
               float facing,
               int threads);

/** \param covered per point of the surface \param reach median spacings that points of
 * the other one may be from the border of a cut */
LooseEnds
looseEnds (const PlacedSurface& surface,
           const std::vector<char>& covered,
           const PlacedSurface& other,
           double reach);

/** \brief Of both clouds. */
struct CloudEnds {
  LooseEnds source;
  LooseEnds target;

  /** \brief Share that is bare in either cloud, the less one. */
  double
  unexplained () const
  {
    return std::min (source.all, target.all);
  }
};

/** \brief What the clouds leave bare of each other.
 * \param samples the source's thin surface, moved \param moved what may cover the
 * target \param near distance within which a place is covered */
CloudEnds
looseEnds (const PointClouds& clouds,
           const MovedPoints& samples,
           const MovedPoints& moved,
           double near,
           const PointResultTuning& tuning,
           int threads);

/** \brief Share of a surface's points that lie on another part of it that faces the
 * same way: limbs that ended on others. \param moved its points now */
double
selfOverlap (const Surface& surface,
             const MovedPoints& moved,
             const SelfOverlapTuning& tuning,
             int threads);

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
