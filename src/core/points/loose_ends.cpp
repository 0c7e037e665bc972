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
coveredPlaces (const MovedPoints& places,
               const MovedPoints& others,
               double most,
               float facing,
               int threads)
{
  const PointTree tree (others.points);
  std::vector<char> covered (places.points.size(), 0);
  parallelFor (threads, static_cast<int> (covered.size()), 128, [&] (int i) {
    const FoundPoint found = tree.nearest (places.points[i]);
    covered[i] = found.index >= 0 && found.squared_distance < most * most &&
                 places.normals[i].dot (others.normals[found.index]) > facing;
  });
  return covered;
}

LooseEnds
looseEnds (const PlacedSurface& surface,
           const std::vector<char>& covered,
           const PlacedSurface& other,
           double reach)
{
  const std::vector<char> borders =
      nearBorders (other.surface, reach * other.surface.median_spacing);
  const PointTree tree (other.points);
  std::vector<char> ends;
  for (const auto& p : surface.points)
    ends.push_back (borders[tree.nearest (p).index]);
  std::vector<char> seen (covered.size(), 0);
  int largest = 0;
  int all = 0;
  for (int i = 0; i < surface.surface.size(); ++i) {
    if (covered[i] || seen[i])
      continue;
    const Piece piece = growPiece (surface.surface, i, covered, ends, seen);
    const bool rimless = piece.steps == 0;
    if (!rimless && 2 * piece.at_border >= piece.steps)
      continue;
    all += piece.points;
    if (!rimless)
      largest = std::max (largest, piece.points);
  }
  const double size = std::max (1.0, static_cast<double> (covered.size()));
  return {largest / size, all / size};
}

CloudEnds
looseEnds (const PointClouds& clouds,
           const MovedPoints& samples,
           const MovedPoints& moved,
           double near,
           const PointResultTuning& tuning,
           int threads)
{
  const Surface& thin = clouds.target.thin;
  const Surface& all = clouds.target.surface;
  const PlacedSurface source{clouds.source.thin, samples.points};
  const PlacedSurface target{thin, thin.points};
  const std::vector<char> of_source = coveredPlaces (
      samples, {all.points, all.normals, {}}, near, tuning.facing, threads);
  const std::vector<char> of_target = coveredPlaces (
      {thin.points, thin.normals, {}}, moved, near, tuning.facing, threads);
  return {looseEnds (source, of_source, target, tuning.border),
          looseEnds (target, of_target, source, tuning.border)};
}

double
selfOverlap (const Surface& surface,
             const MovedPoints& moved,
             const SelfOverlapTuning& tuning,
             int threads)
{
  const double near = tuning.near * surface.median_spacing;
  const double apart = tuning.apart * surface.median_spacing;
  const PointTree tree (moved.points);
  const auto lies_on_another = [&] (int i) {
    std::vector<FoundPoint> found;
    tree.nearest (moved.points[i].data(), tuning.neighbors, found);
    return std::any_of (found.begin(), found.end(), [&] (const FoundPoint& other) {
      return other.squared_distance < near * near &&
             moved.normals[i].dot (moved.normals[other.index]) > tuning.facing &&
             (surface.points[i] - surface.points[other.index]).norm() > apart;
    });
  };
  const int step = 1 + surface.size() / tuning.samples;
  const int samples = (surface.size() + step - 1) / step;
  const int count = parallelSum (
      threads, samples, 32, [&] (int i) { return lies_on_another (step * i) ? 1 : 0; });
  return count / std::max (1.0, static_cast<double> (samples));
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
