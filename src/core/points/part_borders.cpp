// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/part_borders.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <array>

namespace pcl_msf {

namespace {

constexpr int kMost = 3; // parts that a point may choose among

using Parts = std::array<int, kMost>; // -1 = no more
using Costs = std::array<float, kMost>;

std::vector<Parts>
candidates (const PartBorders& b, int threads)
{
  std::vector<Parts> parts (b.surface.size());
  parallelFor (threads, b.surface.size(), 64, [&] (int i) {
    parts[i].fill (-1);
    int count = 0;
    const auto offer = [&] (int part) {
      for (int c = 0; c < count; ++c)
        if (parts[i][c] == part)
          return;
      if (count < kMost)
        parts[i][count++] = part;
    };
    offer (b.part_of[b.segments.label[i]]);
    for (const Membership& m : b.segments.members[i])
      if (b.rigid[b.part_of[m.segment]])
        offer (b.part_of[m.segment]);
  });
  return parts;
}

/** Those of points that have a choice and take one of their candidates. */
PointSamples
takers (const PartBorders& b,
        const std::vector<float>& brightness,
        const std::vector<Parts>& parts,
        int candidate,
        std::vector<int>& place)
{
  PointSamples some;
  for (int i = 0; i < b.surface.size(); ++i)
    if (parts[i][1] >= 0 && parts[i][candidate] >= 0) {
      const bool rigid = b.rigid[parts[i][candidate]] != 0;
      some.points.push_back (b.surface.points[i]);
      some.normals.push_back (b.surface.normals[i]);
      if (!brightness.empty())
        some.brightness.push_back (brightness[i]);
      some.members.push_back (rigid ? b.oneOf (parts[i][candidate])
                                    : b.segments.members[i]);
      place.push_back (i);
    }
  return some;
}

/** Adds how far points are from a target with each of their candidates. */
void
addCosts (const PartBorders& b,
          const BorderView& view,
          const std::vector<Parts>& parts,
          double limit,
          int threads,
          std::vector<Costs>& costs)
{
  for (int c = 0; c < kMost; ++c) { // one candidate after the other, all points
    std::vector<int> place;
    const PointSamples some = takers (b, view.brightness, parts, c, place);
    const std::vector<float> cost =
        view.target.distances (movePoints (some, view.poses, threads),
                               view.rules,
                               limit * view.spacing,
                               threads);
    for (std::size_t k = 0; k < place.size(); ++k)
      costs[place[k]][c] += cost[k];
  }
}

/** Costs as the mean over neighbours that have the same choice. */
void
smooth (const Surface& surface,
        const std::vector<Parts>& parts,
        int threads,
        std::vector<Costs>& costs)
{
  const std::vector<Costs> before = costs;
  parallelFor (threads, surface.size(), 256, [&] (int i) {
    if (parts[i][1] < 0)
      return;
    for (int c = 0; c < kMost && parts[i][c] >= 0; ++c) {
      float sum = before[i][c];
      float weight = 1.0f;
      for (const SurfaceEdge* e = surface.graph.begin (i); e != surface.graph.end (i);
           ++e)
        for (int d = 0; d < kMost; ++d)
          if (parts[e->to][d] == parts[i][c] && parts[e->to][1] >= 0) {
            sum += before[e->to][d];
            weight += 1.0f;
          }
      costs[i][c] = sum / weight;
    }
  });
}

} // namespace

MatchRules
fineRules (double distance, const PointPartTuning& tuning)
{
  MatchRules rules;
  rules.distance = distance;
  rules.normal_length = tuning.normal_length;
  rules.isotropy = tuning.isotropy;
  rules.backward = 0.0;
  return rules;
}

std::vector<Membership>
PartBorders::oneOf (int part) const
{
  const auto k = std::find (part_of.begin(), part_of.end(), part);
  return {{static_cast<int> (k - part_of.begin()), 1.0f}};
}

std::vector<int>
PartBorders::draw (const std::vector<BorderView>& views,
                   const PointPartTuning& tuning,
                   int threads) const
{
  const std::vector<Parts> parts = candidates (*this, threads);
  std::vector<Costs> costs (surface.size(), Costs{});
  for (const BorderView& view : views)
    addCosts (*this, view, parts, tuning.limit, threads, costs);
  for (int round = 0; round < tuning.smoothing; ++round)
    smooth (surface, parts, threads, costs);
  std::vector<int> part;
  for (int i = 0; i < surface.size(); ++i) {
    int best = 0;
    for (int c = 1; c < kMost; ++c)
      if (parts[i][c] >= 0 && costs[i][c] < costs[i][best])
        best = c;
    part.push_back (parts[i][best]);
  }
  return part;
}

} // namespace pcl_msf
