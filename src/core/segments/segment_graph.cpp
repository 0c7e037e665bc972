// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/segment_graph.h"

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include <algorithm>
#include <utility>

namespace pcl_msf {

std::vector<SegmentLink>
linkNearestCentroids (const std::vector<Eigen::Vector3d>& centroids, int neighbors)
{
  const int n = static_cast<int> (centroids.size());
  if (n < 2 || neighbors < 1)
    return {};
  std::vector<float> coordinates;
  for (const auto& c : centroids)
    for (const double value : {c.x(), c.y(), c.z()})
      coordinates.push_back (static_cast<float> (value));
  // FLANN itself: a pcl::PointCloud's memory comes from Eigen's allocator, and which
  // one that is depends on the flags of whoever compiles it, see build_compatibility.h.
  flann::KDTreeSingleIndex<flann::L2_Simple<float>> tree (
      flann::Matrix<float> (coordinates.data(), n, 3),
      flann::KDTreeSingleIndexParams (15));
  tree.buildIndex();
  const auto wanted = static_cast<std::size_t> (std::min (neighbors + 1, n));
  std::vector<std::size_t> found (wanted);
  std::vector<float> distances (wanted);
  std::vector<std::pair<int, int>> pairs;
  for (int k = 0; k < n; ++k) {
    flann::KNNSimpleResultSet<float> nearest (wanted);
    tree.findNeighbors (
        nearest, &coordinates[3 * std::size_t (k)], flann::SearchParams (-1));
    nearest.copy (found.data(), distances.data(), wanted);
    for (const std::size_t index : found) {
      const int other = static_cast<int> (index);
      if (other != k)
        pairs.emplace_back (std::min (k, other), std::max (k, other));
    }
  }
  std::sort (pairs.begin(), pairs.end());
  pairs.erase (std::unique (pairs.begin(), pairs.end()), pairs.end());
  std::vector<SegmentLink> links;
  for (const auto& [j, h] : pairs)
    links.push_back ({j,
                      h,
                      0.5 * (centroids[j] + centroids[h]),
                      0.5 * (centroids[j] - centroids[h]).norm()});
  return links;
}

std::vector<std::vector<int>>
neighborLists (const std::vector<SegmentLink>& links, int segments)
{
  std::vector<std::vector<int>> lists (segments);
  for (const SegmentLink& link : links) {
    lists[link.first].push_back (link.second);
    lists[link.second].push_back (link.first);
  }
  return lists;
}

} // namespace pcl_msf
