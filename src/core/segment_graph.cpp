// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segment_graph.h"

#include <pcl/search/kdtree.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <utility>

namespace pcl_msf {

std::vector<SegmentLink>
linkNearestCentroids (const std::vector<Eigen::Vector3d>& centroids, int neighbors)
{
  const int n = static_cast<int> (centroids.size());
  if (n < 2 || neighbors < 1)
    return {};
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  for (const auto& c : centroids)
    cloud->push_back ({static_cast<float> (c.x()),
                       static_cast<float> (c.y()),
                       static_cast<float> (c.z())});
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud (cloud);
  std::vector<std::pair<int, int>> pairs;
  pcl::Indices found;
  std::vector<float> distances;
  for (int k = 0; k < n; ++k) {
    tree.nearestKSearch (k, std::min (neighbors + 1, n), found, distances);
    for (const int other : found)
      if (other != k)
        pairs.emplace_back (std::min (k, other), std::max (k, other));
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
