// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/surface/surface_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace pcl_msf {

namespace {

/** Farthest-point seeds and each point's nearest one. */
void
plantSeeds (const Surface& surface,
            int count,
            const std::vector<int>& first,
            SurfaceSegments& segments,
            std::vector<float>& distances)
{
  distances.assign (surface.size(), SurfaceGraph::kUnreached);
  segments.label.assign (surface.size(), -1);
  const auto plant = [&] (int seed) {
    const int k = segments.size();
    segments.seeds.push_back (seed);
    surface.graph.spread (seed, distances, [&] (int point, float) {
      segments.label[point] = k;
      return true;
    });
  };
  for (const int seed : first)
    plant (seed);
  if (first.empty())
    plant (0);
  while (segments.size() < std::min (count, surface.size())) {
    const auto farthest = std::max_element (distances.begin(), distances.end());
    if (!(*farthest > 0.0f))
      break;
    plant (static_cast<int> (farthest - distances.begin()));
  }
}

SegmentLink
makeLink (const SurfaceSegments& segments, int a, int b, const Eigen::Vector3d& seam)
{
  return {std::min (a, b),
          std::max (a, b),
          seam,
          0.5 * (segments.centroids[a] - segments.centroids[b]).norm()};
}

void
linkTouching (const Surface& surface, SurfaceSegments& segments)
{
  for (const SurfaceSeam& seam : seamsBetween (surface, segments.label))
    segments.links.push_back (
        makeLink (segments, seam.first, seam.second, seam.center));
}

/** Every piece of the surface hangs on to the nearest segment of a larger one. */
void
linkPieces (const Surface& surface, SurfaceSegments& segments)
{
  const std::vector<int> piece = surface.graph.pieces();
  std::vector<int> piece_of;
  for (const int seed : segments.seeds)
    piece_of.push_back (piece[seed]);
  const int pieces = 1 + *std::max_element (piece_of.begin(), piece_of.end());
  for (int p = 1; p < pieces; ++p) {
    double least = std::numeric_limits<double>::infinity();
    std::pair<int, int> best{-1, -1};
    for (int a = 0; a < segments.size(); ++a)
      for (int b = 0; b < segments.size(); ++b) {
        const double d = (segments.centroids[a] - segments.centroids[b]).squaredNorm();
        if (piece_of[a] == p && piece_of[b] < p && d < least) {
          least = d;
          best = {a, b};
        }
      }
    if (best.first >= 0)
      segments.links.push_back (makeLink (
          segments,
          best.first,
          best.second,
          0.5 * (segments.centroids[best.first] + segments.centroids[best.second])));
  }
}

/** Finds the centroids. */
void
center (const Surface& surface, SurfaceSegments& segments)
{
  std::vector<int> sizes (segments.size(), 0);
  segments.centroids.assign (segments.size(), Eigen::Vector3d::Zero());
  for (int i = 0; i < surface.size(); ++i) {
    segments.centroids[segments.label[i]] += surface.points[i].cast<double>();
    ++sizes[segments.label[i]];
  }
  for (int k = 0; k < segments.size(); ++k)
    segments.centroids[k] /= std::max (1, sizes[k]);
}

/** Weights that fall off with the distance along the surface. */
void
overlap (const Surface& surface, const SurfaceTuning& tuning, SurfaceSegments& segments)
{
  const auto limit = static_cast<float> (tuning.overlap * segments.radius);
  segments.members.assign (surface.size(), {});
  std::vector<float> distances (surface.size(), SurfaceGraph::kUnreached);
  std::vector<int> touched;
  for (int k = 0; k < segments.size(); ++k) {
    touched.clear();
    surface.graph.spread (segments.seeds[k], distances, [&] (int point, float d) {
      touched.push_back (point);
      if (d >= limit)
        return false;
      const float fall = 1.0f - d / limit;
      segments.members[point].push_back ({k, fall * fall});
      return true;
    });
    // Points at the front have a distance, too.
    for (const int point : touched) {
      distances[point] = SurfaceGraph::kUnreached;
      for (const SurfaceEdge* e = surface.graph.begin (point);
           e != surface.graph.end (point);
           ++e)
        distances[e->to] = SurfaceGraph::kUnreached;
    }
  }
  for (int i = 0; i < surface.size(); ++i) {
    auto& list = segments.members[i];
    if (list.empty())
      list.push_back ({segments.label[i], 1.0f});
    std::stable_sort (list.begin(), list.end(), [] (const auto& a, const auto& b) {
      return a.weight > b.weight;
    });
    list.resize (std::min<std::size_t> (list.size(), tuning.members));
    float sum = 0.0f;
    for (const Membership& m : list)
      sum += m.weight;
    for (Membership& m : list)
      m.weight /= sum;
  }
}

} // namespace

std::vector<SurfaceSeam>
seamsBetween (const Surface& surface, const std::vector<int>& label)
{
  std::map<std::pair<int, int>, SurfaceSeam> seams;
  for (int i = 0; i < surface.size(); ++i)
    for (const SurfaceEdge* e = surface.graph.begin (i); e != surface.graph.end (i);
         ++e) {
      const int a = label[i];
      const int b = label[e->to];
      if (a >= b)
        continue;
      SurfaceSeam& seam = seams[{a, b}];
      seam.first = a;
      seam.second = b;
      seam.center += 0.5 * (surface.points[i] + surface.points[e->to]).cast<double>();
      ++seam.edges;
    }
  std::vector<SurfaceSeam> result;
  for (auto& [labels, seam] : seams) {
    seam.center /= seam.edges;
    result.push_back (seam);
  }
  return result;
}

SurfaceSegments
cutSurface (const Surface& surface,
            int count,
            const std::vector<int>& seeds,
            const SurfaceTuning& tuning)
{
  SurfaceSegments segments;
  std::vector<float> distances;
  plantSeeds (surface, count, seeds, segments, distances);
  center (surface, segments);
  double reach = 0.0;
  for (const float d : distances)
    reach = std::max (reach, static_cast<double> (d));
  segments.radius = std::max (reach, 1e-6 * surface.median_spacing);
  linkTouching (surface, segments);
  linkPieces (surface, segments);
  overlap (surface, tuning, segments);
  return segments;
}

SurfaceSegments
takeSegments (const Surface& surface, const std::vector<int>& label, int count)
{
  SurfaceSegments segments;
  segments.given = true;
  segments.label = label;
  segments.seeds.assign (count, -1);
  center (surface, segments);
  std::vector<double> nearest (count, std::numeric_limits<double>::infinity());
  double spread = 0.0;
  for (int i = 0; i < surface.size(); ++i) {
    const int k = label[i];
    const double d =
        (surface.points[i].cast<double>() - segments.centroids[k]).squaredNorm();
    spread += d;
    if (d < nearest[k]) {
      nearest[k] = d;
      segments.seeds[k] = i;
    }
    segments.members.push_back ({{k, 1.0f}});
  }
  // Of a disc the mean squared distance from its middle is half that of the rim.
  segments.radius = std::max (std::sqrt (2.0 * spread / surface.size()),
                              1e-6 * surface.median_spacing);
  linkTouching (surface, segments);
  return segments;
}

} // namespace pcl_msf
