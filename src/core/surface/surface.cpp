// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/surface/surface.h"

#include <Eigen/Geometry>

#include "core/base/parallel_for.h"
#include "core/surface/point_tree.h"
#include "core/surface/surface_normals.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr int kNeighbors = 12;     // of a point, for its normal and the graph
constexpr int kNear = 4;           // of these, for the spacing
constexpr float kReach = 4.0f;     // an edge's length, in spacings of its ends
constexpr float kFacing = -0.35f;  // cosine between the normals of an edge's ends
constexpr float kSteep = 0.9f;     // sine between an edge and its ends' planes
constexpr float kBorderGap = 2.2f; // radians without neighbours
constexpr int kSmallPiece = 12;    // points; smaller ones hang on to the next piece

using Neighbors = std::vector<std::vector<FoundPoint>>; // themselves not among them

Neighbors
findNeighbors (const std::vector<Eigen::Vector3f>& points,
               const PointTree& tree,
               int threads)
{
  Neighbors neighbors (points.size());
  parallelFor (threads, static_cast<int> (points.size()), 256, [&] (int i) {
    auto& found = neighbors[i];
    tree.nearest (points[i].data(), kNeighbors + 1, found);
    found.erase (std::remove_if (found.begin(),
                                 found.end(),
                                 [i] (const FoundPoint& f) { return f.index == i; }),
                 found.end());
  });
  return neighbors;
}

float
spacingOf (const std::vector<FoundPoint>& neighbors)
{
  const std::size_t n = std::min<std::size_t> (kNear, neighbors.size());
  return n > 0 ? std::sqrt (neighbors[n - 1].squared_distance) : 0.0f;
}

float
medianOf (std::vector<float> values)
{
  if (values.empty())
    return 0.0f;
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element (values.begin(), middle, values.end());
  return *middle;
}

/** Are two near points neighbours on one surface? Not through a thin part, not from one
 * part to another that it touches. */
bool
joined (const Surface& s, int a, int b)
{
  const Eigen::Vector3f edge = s.points[b] - s.points[a];
  const float length = edge.norm();
  if (length > kReach * std::max (s.spacing[a], s.spacing[b]))
    return false;
  if (s.normals[a].dot (s.normals[b]) < kFacing)
    return false;
  const float steepest =
      std::max (std::abs (s.normals[a].dot (edge)), std::abs (s.normals[b].dot (edge)));
  return steepest <= kSteep * length || length < 1e-3f * s.median_spacing;
}

bool
atBorder (const Surface& s, int i, const std::vector<FoundPoint>& neighbors)
{
  const Eigen::Vector3f n = s.normals[i];
  const Eigen::Vector3f u = n.unitOrthogonal();
  const Eigen::Vector3f v = n.cross (u);
  std::vector<float> angles;
  for (const FoundPoint& f : neighbors) {
    const Eigen::Vector3f d = s.points[f.index] - s.points[i];
    if (s.normals[f.index].dot (n) > kFacing)
      angles.push_back (std::atan2 (d.dot (v), d.dot (u)));
  }
  if (angles.size() < 3)
    return true;
  std::sort (angles.begin(), angles.end());
  float gap = angles.front() + 2.0f * static_cast<float> (M_PI) - angles.back();
  for (std::size_t k = 1; k < angles.size(); ++k)
    gap = std::max (gap, angles[k] - angles[k - 1]);
  return gap > kBorderGap;
}

std::vector<std::pair<int, int>>
joinedPairs (const Surface& surface, const Neighbors& neighbors)
{
  std::vector<std::pair<int, int>> pairs;
  for (int i = 0; i < surface.size(); ++i)
    for (const FoundPoint& f : neighbors[i])
      if (joined (surface, i, f.index))
        pairs.emplace_back (std::min (i, f.index), std::max (i, f.index));
  std::sort (pairs.begin(), pairs.end());
  pairs.erase (std::unique (pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/** Specks of points hang on to what is nearest. */
void
tieSpecks (const Surface& surface,
           const Neighbors& neighbors,
           std::vector<std::pair<int, int>>& pairs)
{
  std::vector<int> sizes;
  const std::vector<int> piece = surface.graph.pieces (&sizes);
  std::vector<std::pair<float, std::pair<int, int>>> best (
      sizes.size(), {SurfaceGraph::kUnreached, {-1, -1}});
  for (int i = 0; i < surface.size(); ++i)
    if (sizes[piece[i]] < kSmallPiece)
      for (const FoundPoint& f : neighbors[i])
        if (piece[f.index] < piece[i]) // a larger one, or one before it
          best[piece[i]] = std::min (
              best[piece[i]],
              {f.squared_distance, {std::min (i, f.index), std::max (i, f.index)}});
  for (const auto& [distance, pair] : best)
    if (pair.first >= 0)
      pairs.push_back (pair);
}

/** Finds neighbours and spacings. */
Neighbors
spaceOut (Surface& surface, int threads)
{
  Neighbors neighbors =
      findNeighbors (surface.points, PointTree (surface.points), threads);
  for (const auto& found : neighbors)
    surface.spacing.push_back (spacingOf (found));
  surface.median_spacing = medianOf (surface.spacing);
  return neighbors;
}

/** Finds graph and borders. */
void
connect (Surface& surface, const Neighbors& neighbors, int threads)
{
  std::vector<std::pair<int, int>> pairs = joinedPairs (surface, neighbors);
  surface.graph = SurfaceGraph (surface.points, pairs);
  tieSpecks (surface, neighbors, pairs);
  surface.graph = SurfaceGraph (surface.points, std::move (pairs));
  surface.border.resize (surface.size());
  parallelFor (threads, surface.size(), 256, [&] (int i) {
    surface.border[i] = atBorder (surface, i, neighbors[i]);
  });
}

} // namespace

Surface
makeSurface (std::vector<Eigen::Vector3f> points, int threads)
{
  Surface surface;
  surface.points = std::move (points);
  const Neighbors neighbors = spaceOut (surface, threads);
  surface.normals = surfaceNormals (surface.points, neighbors, threads);
  connect (surface, neighbors, threads);
  return surface;
}

Surface
thinSurface (const Surface& surface, const std::vector<int>& chosen, int threads)
{
  Surface thin;
  for (const int i : chosen) {
    thin.points.push_back (surface.points[i]);
    thin.normals.push_back (surface.normals[i]);
  }
  const Neighbors neighbors = spaceOut (thin, threads);
  connect (thin, neighbors, threads);
  return thin;
}

std::vector<char>
onSurface (const std::vector<Eigen::Vector3f>& points, int threads)
{
  constexpr float far = 5.0f;   // spacings: alone
  constexpr float loose = 2.2f; // spacings: alone unless its neighbours lie flat
  constexpr float flat = 0.35f; // of its spacing: across its neighbours' plane
  const PointTree tree (points);
  const Neighbors neighbors = findNeighbors (points, tree, threads);
  std::vector<float> spacing;
  for (const auto& found : neighbors)
    spacing.push_back (spacingOf (found));
  const float median = medianOf (spacing);
  std::vector<char> kept (points.size(), 1);
  parallelFor (threads, static_cast<int> (points.size()), 256, [&] (int i) {
    if (spacing[i] > far * median)
      kept[i] = 0;
    else if (spacing[i] > loose * median) {
      const PlaneFit plane = fitNeighbors (points, i, neighbors[i]);
      kept[i] = std::max (plane.offset, plane.roughness) < flat * spacing[i];
    }
  });
  return kept;
}

} // namespace pcl_msf
