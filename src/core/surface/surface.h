// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/surface_tuning.h"
#include "core/surface/surface_graph.h"

#include <vector>

namespace pcl_msf {

/** \brief Points that sample a surface, with what the points alone tell of it. */
struct Surface {
  std::vector<Eigen::Vector3f> points;
  std::vector<Eigen::Vector3f> normals; ///< unit; outwards where the surface is closed
  std::vector<float> spacing;           ///< to the near neighbours, per point
  std::vector<char> border;             ///< at the rim of a hole or a cut
  SurfaceGraph graph;
  double median_spacing{0.0};

  int
  size () const
  {
    return static_cast<int> (points.size());
  }
};

/** \brief Finds normals, the graph and the borders of points. */
Surface
makeSurface (std::vector<Eigen::Vector3f> points,
             const SurfaceTuning& tuning,
             int threads);

/** \brief Some points of a surface as one of its own: they keep their normals. */
Surface
thinSurface (const Surface& surface,
             const std::vector<int>& chosen,
             const SurfaceTuning& tuning,
             int threads);

/** \brief The surface of those points that lie on one: not of one that is far from all
 * others or whose few neighbours lie around it like dust.
 * \param[out] kept their indices, ascending
 * \param normals per point, as surfaceNormals takes given ones */
Surface
makeCleanSurface (std::vector<Eigen::Vector3f> points,
                  const SurfaceTuning& tuning,
                  int threads,
                  std::vector<int>& kept,
                  std::vector<Eigen::Vector3f> normals = {});

/** \brief Connects pieces of a surface that belong to different segments and all but
 * touch, as faces do whose edge was left out. \param segment per point */
void
bridgeSegments (Surface& surface,
                const std::vector<int>& segment,
                const SurfaceTuning& tuning,
                int threads);

} // namespace pcl_msf
