// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/surface/surface.h"

#include <Eigen/Geometry>

#include "core/base/order_statistics.h"
#include "core/base/parallel_for.h"
#include "core/surface/point_tree.h"
#include "core/surface/surface_normals.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

using Neighbors = std::vector<std::vector<FoundPoint>>; // themselves not among them

Neighbors
findNeighbors (const std::vector<Eigen::Vector3f>& points,
               const PointTree& tree,
               int count,
               int threads)
{
  Neighbors neighbors (points.size());
  parallelFor (threads, static_cast<int> (points.size()), 256, [&] (int i) {
    auto& found = neighbors[i];
    tree.nearest (points[i].data(), count + 1, found);
    found.erase (std::remove_if (found.begin(),
                                 found.end(),
                                 [i] (const FoundPoint& f) { return f.index == i; }),
                 found.end());
  });
  return neighbors;
}

float
spacingOf (const std::vector<FoundPoint>& neighbors, int near)
{
  const std::size_t n = std::min<std::size_t> (near, neighbors.size());
  return n > 0 ? std::sqrt (neighbors[n - 1].squared_distance) : 0.0f;
}

float
medianOf (std::vector<float> values)
{
  if (values.empty())
    return 0.0f;
  return median (values);
}

/** Are two near points neighbours on one surface? Not through a thin part, not from one
 * part to another that it touches. */
bool
joined (const Surface& s, int a, int b, const SurfaceTuning& tuning)
{
  const Eigen::Vector3f edge = s.points[b] - s.points[a];
  const float length = edge.norm();
  if (length > tuning.reach * std::max (s.spacing[a], s.spacing[b]))
    return false;
  if (s.normals[a].dot (s.normals[b]) < tuning.facing)
    return false;
  const float steepest =
      std::max (std::abs (s.normals[a].dot (edge)), std::abs (s.normals[b].dot (edge)));
  return steepest <= tuning.steep * length || length < 1e-3f * s.median_spacing;
}

bool
atBorder (const Surface& s,
          int i,
          const std::vector<FoundPoint>& neighbors,
          const SurfaceTuning& tuning)
{
  const Eigen::Vector3f n = s.normals[i];
  const Eigen::Vector3f u = n.unitOrthogonal();
  const Eigen::Vector3f v = n.cross (u);
  std::vector<float> angles;
  for (const FoundPoint& f : neighbors) {
    const Eigen::Vector3f d = s.points[f.index] - s.points[i];
    if (s.normals[f.index].dot (n) > tuning.facing)
      angles.push_back (std::atan2 (d.dot (v), d.dot (u)));
  }
  if (angles.size() < 3)
    return true;
  std::sort (angles.begin(), angles.end());
  float gap = angles.front() + 2.0f * static_cast<float> (M_PI) - angles.back();
  for (std::size_t k = 1; k < angles.size(); ++k)
    gap = std::max (gap, angles[k] - angles[k - 1]);
  return gap > tuning.border_gap;
}

std::vector<std::pair<int, int>>
joinedPairs (const Surface& surface,
             const Neighbors& neighbors,
             const SurfaceTuning& tuning)
{
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < surface.size(); ++i)
    for (const FoundPoint& f : neighbors[i])
      if (joined (surface, i, f.index, tuning))
        pairs.emplace_back (std::min (i, f.index), std::max (i, f.index));
  std::sort (pairs.begin(), pairs.end());
  pairs.erase (std::unique (pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/** Specks of points hang on to what is nearest. */
void
tieSpecks (const Surface& surface,
           const Neighbors& neighbors,
           int small,
           std::vector<std::pair<int, int>>& pairs)
{
  std::vector<int> sizes;
  const std::vector<int> piece = surface.graph.pieces (&sizes);
  std::vector<std::pair<float, std::pair<int, int>>> best (
      sizes.size(), {SurfaceGraph::kUnreached, {-1, -1}});
  for (int i = 0; i < surface.size(); ++i)
    if (sizes[piece[i]] < small)
      for (const FoundPoint& f : neighbors[i])
        if (piece[f.index] < piece[i]) // a larger one, or one before it
          best[piece[i]] = std::min (
              best[piece[i]],
              {f.squared_distance, {std::min (i, f.index), std::max (i, f.index)}});
  for (const auto& [distance, pair] : best)
    if (pair.first >= 0)
      pairs.push_back (pair);
}

/** Leaves only some points, with the normals that they have. */
void
keepPoints (const std::vector<int>& kept, Surface& surface)
{
  for (auto* vectors : {&surface.points, &surface.normals}) {
    if (vectors->empty())
      continue;
    for (std::size_t i = 0; i < kept.size(); ++i)
      (*vectors)[i] = (*vectors)[kept[i]];
    vectors->resize (kept.size());
  }
}

/** Finds neighbours and spacings. */
Neighbors
spaceOut (Surface& surface, const SurfaceTuning& tuning, int threads)
{
  Neighbors neighbors = findNeighbors (
      surface.points, PointTree (surface.points), tuning.neighbors, threads);
  surface.spacing.clear();
  for (const auto& found : neighbors)
    surface.spacing.push_back (spacingOf (found, tuning.near));
  surface.median_spacing = medianOf (surface.spacing);
  return neighbors;
}

/** Indices of the points that lie on a surface. */
std::vector<int>
onSurface (const Surface& surface,
           const Neighbors& neighbors,
           const SurfaceTuning& tuning,
           int threads)
{
  const double median = surface.median_spacing;
  std::vector<char> on (surface.size(), 1);
  parallelFor (threads, surface.size(), 256, [&] (int i) {
    const float spacing = surface.spacing[i];
    if (spacing > tuning.dust_far * median)
      on[i] = 0;
    else if (spacing > tuning.dust_loose * median) {
      const PlaneFit plane = fitNeighbors (surface.points, i, neighbors[i]);
      on[i] = std::max (plane.offset, plane.roughness) < tuning.dust_flat * spacing;
    }
  });
  std::vector<int> kept;
  for (int i = 0; i < surface.size(); ++i)
    if (on[i])
      kept.push_back (i);
  return kept;
}

/** Finds graph and borders. */
void
connect (Surface& surface,
         const Neighbors& neighbors,
         const SurfaceTuning& tuning,
         int threads)
{
  std::vector<std::pair<int, int>> pairs = joinedPairs (surface, neighbors, tuning);
  surface.graph = SurfaceGraph (surface.points, pairs);
  tieSpecks (surface, neighbors, tuning.small_piece, pairs);
  surface.graph = SurfaceGraph (surface.points, std::move (pairs));
  surface.border.resize (surface.size());
  parallelFor (threads, surface.size(), 256, [&] (int i) {
    surface.border[i] = atBorder (surface, i, neighbors[i], tuning);
  });
}

/** Finds normals, but for those that are there, graph and borders. */
void
finish (Surface& surface,
        const Neighbors& neighbors,
        const SurfaceTuning& tuning,
        int threads)
{
  surface.normals =
      surfaceNormals (surface.points, neighbors, tuning, threads, surface.normals);
  connect (surface, neighbors, tuning, threads);
}

} // namespace

Surface
makeSurface (std::vector<Eigen::Vector3f> points,
             const SurfaceTuning& tuning,
             int threads)
{
  Surface surface;
  surface.points = std::move (points);
  const Neighbors neighbors = spaceOut (surface, tuning, threads);
  finish (surface, neighbors, tuning, threads);
  return surface;
}

Surface
makeCleanSurface (std::vector<Eigen::Vector3f> points,
                  const SurfaceTuning& tuning,
                  int threads,
                  std::vector<int>& kept,
                  std::vector<Eigen::Vector3f> normals)
{
  Surface surface;
  surface.points = std::move (points);
  surface.normals = std::move (normals);
  Neighbors neighbors = spaceOut (surface, tuning, threads);
  kept = onSurface (surface, neighbors, tuning, threads);
  if (static_cast<int> (kept.size()) < surface.size()) {
    keepPoints (kept, surface);
    neighbors = spaceOut (surface, tuning, threads);
  }
  finish (surface, neighbors, tuning, threads);
  return surface;
}

void
bridgeSegments (Surface& surface,
                const std::vector<int>& segment,
                const SurfaceTuning& tuning,
                int threads)
{
  const float reach = tuning.bridge_reach * static_cast<float> (surface.median_spacing);
  const std::vector<int> piece = surface.graph.pieces();
  if (*std::max_element (piece.begin(), piece.end()) == 0)
    return;
  const Neighbors neighbors = findNeighbors (
      surface.points, PointTree (surface.points), tuning.bridge_neighbors, threads);
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < surface.size(); ++i) {
    for (const SurfaceEdge* e = surface.graph.begin (i); e != surface.graph.end (i);
         ++e)
      if (i < e->to)
        pairs.emplace_back (i, e->to);
    for (const FoundPoint& f : neighbors[i])
      if (f.squared_distance < reach * reach && piece[f.index] != piece[i] &&
          segment[f.index] != segment[i])
        pairs.emplace_back (std::min (i, f.index), std::max (i, f.index));
  }
  std::sort (pairs.begin(), pairs.end());
  pairs.erase (std::unique (pairs.begin(), pairs.end()), pairs.end());
  surface.graph = SurfaceGraph (surface.points, std::move (pairs));
}

Surface
thinSurface (const Surface& surface,
             const std::vector<int>& chosen,
             const SurfaceTuning& tuning,
             int threads)
{
  Surface thin;
  for (const int i : chosen) {
    thin.points.push_back (surface.points[i]);
    thin.normals.push_back (surface.normals[i]);
  }
  const Neighbors neighbors = spaceOut (thin, tuning, threads);
  connect (thin, neighbors, tuning, threads);
  return thin;
}

} // namespace pcl_msf
