// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Core>

#include "core/segments/segment_graph.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace {

using namespace pcl_msf;

std::vector<Eigen::Vector3d>
randomCentroids (int count)
{
  std::mt19937 generator (4);
  std::uniform_real_distribution<double> uniform (-1.0, 1.0);
  std::vector<Eigen::Vector3d> result;
  for (int i = 0; i < count; ++i)
    result.emplace_back (
        uniform (generator), uniform (generator), 2.0 + uniform (generator));
  return result;
}

/** Every pair in which one is among the other's nearest, by brute force. */
std::set<std::pair<int, int>>
nearestPairs (const std::vector<Eigen::Vector3d>& centroids, int neighbors)
{
  std::set<std::pair<int, int>> pairs;
  const int n = static_cast<int> (centroids.size());
  for (int k = 0; k < n; ++k) {
    std::vector<int> order (n);
    std::iota (order.begin(), order.end(), 0);
    std::sort (order.begin(), order.end(), [&] (int a, int b) {
      return (centroids[a] - centroids[k]).norm() <
             (centroids[b] - centroids[k]).norm();
    });
    for (int i = 1; i <= std::min (neighbors, n - 1); ++i)
      pairs.insert (std::minmax (k, order[i]));
  }
  return pairs;
}

class Graph : public testing::TestWithParam<int> {};

TEST_P (Graph, LinksExactlyTheNearestCentroids)
{
  const auto centroids = randomCentroids (60);
  const auto links = linkNearestCentroids (centroids, GetParam());
  std::set<std::pair<int, int>> found;
  for (const SegmentLink& link : links) {
    EXPECT_LT (link.first, link.second);
    EXPECT_TRUE (found.insert ({link.first, link.second}).second) << "twice";
  }
  EXPECT_EQ (found, nearestPairs (centroids, GetParam()));
  EXPECT_TRUE (std::is_sorted (
      links.begin(), links.end(), [] (const SegmentLink& a, const SegmentLink& b) {
        return std::pair (a.first, a.second) < std::pair (b.first, b.second);
      }));
}

TEST_P (Graph, LinksKnowTheirPlaceAndLever)
{
  const auto centroids = randomCentroids (20);
  for (const SegmentLink& l : linkNearestCentroids (centroids, GetParam())) {
    const Eigen::Vector3d& a = centroids[l.first];
    const Eigen::Vector3d& b = centroids[l.second];
    EXPECT_LT ((l.midpoint - 0.5 * (a + b)).norm(), 1e-12);
    EXPECT_NEAR (l.lever, 0.5 * (a - b).norm(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P (Neighbors, Graph, testing::Values (1, 3, 6, 64));

TEST (SegmentGraph, NothingToLink)
{
  EXPECT_TRUE (linkNearestCentroids ({}, 6).empty());
  EXPECT_TRUE (linkNearestCentroids (randomCentroids (1), 6).empty());
  EXPECT_TRUE (linkNearestCentroids (randomCentroids (9), 0).empty());
}

TEST (SegmentGraph, EqualCentroidsAreLinked)
{
  const std::vector<Eigen::Vector3d> same (3, Eigen::Vector3d (0.1, 0.2, 2.0));
  EXPECT_EQ (linkNearestCentroids (same, 2).size(), 3u);
}

TEST (SegmentGraph, NeighborListsAreMutual)
{
  const auto links = linkNearestCentroids (randomCentroids (30), 4);
  const auto lists = neighborLists (links, 30);
  std::size_t entries = 0;
  for (int k = 0; k < 30; ++k)
    for (const int n : lists[k]) {
      ++entries;
      EXPECT_EQ (std::count (lists[n].begin(), lists[n].end(), k), 1);
    }
  EXPECT_EQ (entries, 2 * links.size());
}

} // namespace
