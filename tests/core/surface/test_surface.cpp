// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/surface/point_tree.h"
#include "core/surface/surface.h"
#include "core/surface/surface_segments.h"
#include "core/surface/thinning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace {

using namespace pcl_msf;

using Points = std::vector<Eigen::Vector3f>;

/** A sphere of radius 1 by a spiral. */
Points
sphere (int count, const Eigen::Vector3f& center = Eigen::Vector3f::Zero())
{
  Points points;
  for (int i = 0; i < count; ++i) {
    const float z = 1.0f - 2.0f * (i + 0.5f) / count;
    const float r = std::sqrt (1.0f - z * z);
    const float a = 2.39996323f * i;
    points.push_back (center + Eigen::Vector3f (r * std::cos (a), r * std::sin (a), z));
  }
  return points;
}

TEST (PointTree, FindsTheNearestInOrder)
{
  const PointTree tree (Points{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {1, 0, 0}});
  EXPECT_EQ (tree.nearest (Eigen::Vector3f (2.6f, 0, 0)).index, 2);
  std::vector<FoundPoint> found;
  tree.nearest (Eigen::Vector3f (0.9f, 0, 0).data(), 3, found);
  ASSERT_EQ (found.size(), 3u);
  EXPECT_EQ (found[0].index, 1); // of two at one place the first
  EXPECT_EQ (found[1].index, 3);
  EXPECT_EQ (found[2].index, 0);
  EXPECT_EQ (tree.nearest (Eigen::Vector3f (NAN, 0, 0)).index, -1);
  EXPECT_EQ (PointTree().nearest (Eigen::Vector3f::Zero()).index, -1);
}

/** The nearest one the slow way. */
int
nearestOf (const std::vector<float>& rows, const std::array<float, 6>& query)
{
  int best = -1;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < rows.size() / 6; ++i) {
    float sum = 0.0f;
    for (int d = 0; d < 6; ++d)
      sum += (rows[6 * i + d] - query[d]) * (rows[6 * i + d] - query[d]);
    if (sum < least) {
      least = sum;
      best = static_cast<int> (i);
    }
  }
  return best;
}

TEST (PointTree, FindsPointsThatMovedWithAnyHint)
{
  std::mt19937 random (5);
  std::uniform_real_distribution<float> place (-1.0f, 1.0f);
  const auto draw = [&] { return place (random); };
  std::vector<float> rows (6 * 700);
  std::generate (rows.begin(), rows.end(), draw);
  PointTree tree (rows, 6);
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 300; ++i) {
      std::array<float, 6> query{};
      std::generate (query.begin(), query.end(), draw);
      const int expected = nearestOf (rows, query);
      for (const int hint : {-1, expected, 2 * i, 100000})
        ASSERT_EQ (tree.nearest (query.data(), hint).index, expected) << hint;
    }
    // At first along with their neighbours, then to anywhere.
    for (float& x : rows)
      x = round == 0 ? 0.5f * x + 0.3f : draw();
    tree.move (rows);
  }
}

TEST (Surface, NormalsOfAClosedSurfacePointOutwards)
{
  const Surface surface = makeSurface (sphere (2000), {}, 2);
  for (int i = 0; i < surface.size(); ++i) {
    EXPECT_GT (surface.normals[i].dot (surface.points[i]), 0.97f) << i;
    EXPECT_FALSE (surface.border[i]) << i;
  }
  std::vector<int> sizes;
  surface.graph.pieces (&sizes);
  EXPECT_EQ (sizes.size(), 1u);
}

TEST (Surface, GivenNormalsStayButForLengthAndSide)
{
  const Points points = sphere (2000);
  Points normals = points;
  for (std::size_t i = 0; i < normals.size(); ++i)
    normals[i] *= i % 3 == 0 ? -5.0f : 1e-30f;
  normals[7] = Eigen::Vector3f::Zero();
  normals[8].setConstant (std::numeric_limits<float>::quiet_NaN());
  std::vector<int> kept;
  const Surface surface = makeCleanSurface (points, {}, 2, kept, normals);
  ASSERT_EQ (surface.size(), 2000);
  for (int i = 0; i < surface.size(); ++i)
    EXPECT_GT (surface.normals[i].dot (points[i]), i == 7 || i == 8 ? 0.97f : 0.99999f)
        << i;
}

TEST (Surface, GivenNormalsOfDustLeaveWithIt)
{
  Points points = sphere (2000);
  points.insert (points.begin(), Eigen::Vector3f (9.0f, 9.0f, 9.0f));
  std::vector<int> kept;
  const Surface surface = makeCleanSurface (points, {}, 2, kept, points);
  ASSERT_EQ (surface.size(), 2000);
  for (int i = 0; i < surface.size(); ++i)
    EXPECT_GT (surface.normals[i].dot (surface.points[i]), 0.99999f) << i;
}

TEST (Surface, DistancesRunAlongIt)
{
  const Points points = sphere (4000);
  const Surface surface = makeSurface (points, {}, 2);
  std::vector<float> distance (points.size(), SurfaceGraph::kUnreached);
  surface.graph.spread (0, distance, [] (int, float) { return true; });
  // From pole to pole: pi, not 2 through the middle; a graph's ways are a bit longer.
  EXPECT_NEAR (distance.back(), M_PI, 0.1 * M_PI);
  EXPECT_GT (distance.back(), 3.1f);
}

TEST (Surface, NeverBridgesAGap)
{
  // Two bodies that all but touch: the gap is narrower than an edge may be long.
  Points points = sphere (3000);
  const Points other = sphere (3000, Eigen::Vector3f (2.2f, 0, 0));
  points.insert (points.end(), other.begin(), other.end());
  const Surface surface = makeSurface (points, {}, 2);
  for (int i = 0; i < surface.size(); ++i)
    for (const SurfaceEdge* e = surface.graph.begin (i); e != surface.graph.end (i);
         ++e)
      EXPECT_EQ (i < 3000, e->to < 3000) << i << " " << e->to;
}

TEST (Surface, SeesItsBorder)
{
  Points points;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 30; ++x)
      points.emplace_back (0.1f * x, 0.1f * y, 0.0f);
  const Surface surface = makeSurface (points, {}, 1);
  EXPECT_TRUE (surface.border[0]);
  EXPECT_TRUE (surface.border[15]);
  EXPECT_FALSE (surface.border[15 * 30 + 15]);
}

TEST (Surface, DustIsNotOnIt)
{
  Points points = sphere (3000);
  std::mt19937 random (3);
  std::uniform_real_distribution<float> place (-1.5f, 1.5f);
  std::vector<char> is_dust (points.size(), 0);
  while (points.size() < 3600) {
    const Eigen::Vector3f p (place (random), place (random), place (random));
    if (std::abs (p.norm() - 1.0f) < 0.25f)
      continue;
    points.push_back (p);
    is_dust.push_back (1);
  }
  std::vector<int> kept;
  const Surface surface = makeCleanSurface (points, {}, 2, kept);
  ASSERT_EQ (surface.size(), static_cast<int> (kept.size()));
  int dust = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    dust += is_dust[kept[i]];
    EXPECT_EQ (surface.points[i], points[kept[i]]);
  }
  EXPECT_LE (dust, 120);                                       // of 600
  EXPECT_GE (static_cast<int> (kept.size()) - dust, 3000 - 3); // of 3000
}

TEST (SurfaceSegments, CutEvenlyAndHoldTogether)
{
  const Surface surface = makeSurface (sphere (3000), {}, 2);
  const SurfaceSegments coarse = cutSurface (surface, 10, {}, {});
  const SurfaceSegments fine = cutSurface (surface, 40, coarse.seeds, {});
  ASSERT_EQ (fine.size(), 40);
  for (int k = 0; k < 10; ++k)
    EXPECT_EQ (fine.seeds[k], coarse.seeds[k]);
  std::vector<int> sizes (40, 0);
  for (const int label : fine.label)
    ++sizes.at (label);
  for (const int size : sizes)
    EXPECT_GT (size, 15);
  for (const auto& members : fine.members) {
    float sum = 0.0f;
    for (const Membership& m : members)
      sum += m.weight;
    EXPECT_NEAR (sum, 1.0f, 1e-5f);
  }
  std::set<int> linked;
  for (const SegmentLink& link : fine.links) {
    EXPECT_LT (link.first, link.second);
    linked.insert (link.first);
    linked.insert (link.second);
  }
  EXPECT_EQ (linked.size(), 40u);
}

TEST (SurfaceSegments, PiecesHangTogether)
{
  Points points = sphere (1500);
  const Points other = sphere (500, Eigen::Vector3f (5.0f, 0, 0));
  points.insert (points.end(), other.begin(), other.end());
  const SurfaceSegments segments = cutSurface (makeSurface (points, {}, 1), 20, {}, {});
  int across = 0;
  for (const SegmentLink& link : segments.links)
    across +=
        (segments.seeds[link.first] < 1500) != (segments.seeds[link.second] < 1500);
  EXPECT_EQ (across, 1);
}

TEST (Thinning, KeepsAboutTheNumberAndSpreads)
{
  const Points points = sphere (20000);
  const std::vector<int> thin = thinPoints (points, {}, 1000);
  EXPECT_NEAR (static_cast<double> (thin.size()), 1000.0, 200.0);
  EXPECT_EQ (thinPoints (points, {}, 30000).size(), points.size());
  const std::vector<int> spread = spreadPoints (points, thin, 6);
  ASSERT_EQ (spread.size(), 6u);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j)
      EXPECT_GT ((points[thin[spread[i]]] - points[thin[spread[j]]]).norm(), 0.8f);
}

TEST (Surface, SamplesOfAFlatPieceFaceOneSide)
{
  std::mt19937 random (4);
  const auto uniform = [&random] { return random() / 4294967296.0f; };
  for (int axis = 0; axis < 3; ++axis)
    for (int sample = 0; sample < 8; ++sample) {
      Points points;
      for (int i = 0; i < 500; ++i) {
        points.emplace_back (uniform(), uniform(), uniform());
        points.back()[axis] = 0.3f + 1e-3f * uniform();
      }
      EXPECT_GT (makeSurface (points, {}, 1).normals[7][axis], 0.9f);
    }
}

} // namespace
