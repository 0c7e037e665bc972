// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/motion/motion_state.h"
#include "core/surface/surface.h"

#include <vector>

namespace pcl_msf {

/** \brief A segment that a point follows, and by how much. */
struct Membership {
  int segment{0};
  float weight{0.0f};
};

/** \brief A surface cut into segments of about equal size along it. */
struct SurfaceSegments {
  std::vector<int> seeds;                       ///< per segment, a point
  std::vector<int> label;                       ///< per point
  std::vector<Eigen::Vector3d> centroids;       ///< per segment
  std::vector<SegmentLink> links;               ///< of segments that touch
  std::vector<std::vector<Membership>> members; ///< per point: own and near segments
  double radius{0.0};                           ///< typical, along the surface
  bool given{false};       ///< from outside: a point follows its own segment alone
  std::vector<char> fixed; ///< per segment: keeps its motion; empty = none does

  bool
  isFixed (int segment) const
  {
    return !fixed.empty() && fixed[segment] != 0;
  }

  int
  size () const
  {
    return static_cast<int> (seeds.size());
  }
};

/** \brief Where two regions of a surface touch. */
struct SurfaceSeam {
  int first{0}; ///< label, less than the second
  int second{0};
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};
  int edges{0}; ///< of the graph that cross it
};

/** \brief The seams between regions, by their labels. \param label per point */
std::vector<SurfaceSeam>
seamsBetween (const Surface& surface, const std::vector<int>& label);

/** \brief Seeds far from each other along the surface, every point with its nearest.
 * \param seeds of a coarser cut to keep, may be empty */
SurfaceSegments
cutSurface (const Surface& surface,
            int count,
            const std::vector<int>& seeds,
            const SurfaceTuning& tuning);

/** \brief Takes segments from outside; those that touch are linked.
 * \param label per point, 0 to count - 1; each has a point */
SurfaceSegments
takeSegments (const Surface& surface, const std::vector<int>& label, int count);

} // namespace pcl_msf
