// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/loose_ends.h"

#include "core/base/parallel_for.h"
#include "core/surface/point_tree.h"

#include <algorithm>

namespace pcl_msf {

namespace {

/** Per point: is a border within a distance along the surface? */
std::vector<char>
nearBorders (const Surface& surface, double reach)
{
  const auto limit = static_cast<float> (reach);
  std::vector<float> distances (surface.size(), SurfaceGraph::kUnreached);
  for (int i = 0; i < surface.size(); ++i)
    if (surface.border[i])
      surface.graph.spread (i, distances, [limit] (int, float d) { return d < limit; });
  std::vector<char> near;
  for (const float d : distances)
    near.push_back (d <= limit);
  return near;
}

/** A connected piece of a surface and the steps that lead out of it. */
struct Piece {
  int points{0};
  int steps{0};
  int at_border{0}; ///< steps to where the other surface ends
};

/** \param ends per point: does the other surface end there? */
Piece
growPiece (const Surface& surface,
           int start,
           const std::vector<char>& covered,
           const std::vector<char>& ends,
           std::vector<char>& seen)
{
  Piece piece;
  std::vector<int> front{start};
  seen[start] = 1;
  while (!front.empty()) {
    const int i = front.back();
    front.pop_back();
    ++piece.points;
    for (const SurfaceEdge* e = surface.graph.begin (i); e != surface.graph.end (i);
         ++e)
      if (covered[e->to]) {
        ++piece.steps;
        piece.at_border += ends[e->to];
      }
      else if (!seen[e->to]) {
        seen[e->to] = 1;
        front.push_back (e->to);
      }
  }
  return piece;
}

} // namespace

std::vector<char>
coveredPlaces (const Surface& surface,
               const MovedPoints& moved,
               double most,
               float facing,
               int threads)
{
  const PointTree tree (moved.points);
  std::vector<char> covered (surface.size(), 0);
  parallelFor (threads, surface.size(), 128, [&] (int i) {
    const FoundPoint found = tree.nearest (surface.points[i]);
    covered[i] = found.index >= 0 && found.squared_distance < most * most &&
                 surface.normals[i].dot (moved.normals[found.index]) > facing;
  });
  return covered;
}

double
largestLooseEnd (const PointClouds& clouds,
                 const std::vector<Eigen::Vector3f>& samples,
                 const std::vector<char>& covered,
                 double reach)
{
  const Surface& source = clouds.source.thin;
  const Surface& target = clouds.target.thin;
  const std::vector<char> borders = nearBorders (source, reach * source.median_spacing);
  const PointTree tree (samples);
  std::vector<char> ends;
  for (const auto& p : target.points)
    ends.push_back (borders[tree.nearest (p).index]);
  std::vector<char> seen (target.size(), 0);
  int largest = 0;
  for (int i = 0; i < target.size(); ++i) {
    if (covered[i] || seen[i])
      continue;
    const Piece piece = growPiece (target, i, covered, ends, seen);
    if (2 * piece.at_border < piece.steps)
      largest = std::max (largest, piece.points);
  }
  return largest / std::max (1.0, static_cast<double> (target.size()));
}

double
meanGap (const SurfaceSegments& segments, const std::vector<RigidPose>& poses)
{
  double sum = 0.0;
  for (const SegmentLink& link : segments.links)
    sum +=
        (poses[link.first] * link.midpoint - poses[link.second] * link.midpoint).norm();
  return sum / (segments.radius * std::max<std::size_t> (1, segments.links.size()));
}

std::vector<float>
stretchOf (const Surface& surface,
           const std::vector<Eigen::Vector3f>& moved,
           int threads)
{
  std::vector<float> stretch (surface.size(), 0.0f);
  parallelFor (threads, surface.size(), 256, [&] (int i) {
    float sum = 0.0f;
    int count = 0;
    for (const SurfaceEdge* e = surface.graph.begin (i); e != surface.graph.end (i);
         ++e) {
      const float now = (moved[i] - moved[e->to]).norm();
      const float least = 1e-3f * e->length;
      sum += std::max (now / std::max (e->length, 1e-12f),
                       e->length / std::max (now, least + 1e-12f)) -
             1.0f;
      ++count;
    }
    stretch[i] = count > 0 ? sum / static_cast<float> (count) : 0.0f;
  });
  return stretch;
}

} // namespace pcl_msf
