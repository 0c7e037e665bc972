// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/surface/surface.h"

#include <vector>

namespace pcl_msf {

/** \brief A point of the source and one of the target that may be the same. */
struct PointPair {
  int source{-1};
  int target{-1};
  double weight{0.0};
};

/** \brief Finds points again by what bending keeps: the distances along the surface to
 * others. Lengths in the unit of the points. */
class SurfaceIsometry {
public:
  /** \param pairs that may be right; kept as anchors are those that keep the distances
   * to most of the others \param size of the source, what a slack is measured by
   * \param least_agreement of an anchor with the others, mean, at least: more leaves
   * few anchors, less lets wrong ones in \param tuning must outlive this */
  SurfaceIsometry (const Surface& source,
                   const Surface& target,
                   const std::vector<PointPair>& pairs,
                   double size,
                   double least_agreement,
                   const IsometryTuning& tuning,
                   int threads);

  int
  anchors () const
  {
    return static_cast<int> (source_rows_.size());
  }

  /** \brief For points of the source those of the target with the same distances to the
   * anchors; a match weighs less the less the way back leads to the point. */
  std::vector<PointPair>
  match (const std::vector<int>& source_points,
         const std::vector<int>& target_points,
         int threads) const;

private:
  using Rows = std::vector<std::vector<float>>; ///< per anchor, to every point

  float
  agreement (float a, float b) const;
  void
  keepConsistent (const std::vector<PointPair>& pairs, double least_agreement);
  std::vector<float>
  scores (int source_point, const Rows& target_rows) const;

  const Surface& source_;
  const IsometryTuning& tuning_;
  float size_;
  Rows source_rows_;
  Rows target_rows_;
};

} // namespace pcl_msf
