// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/surface/point_tree.h"

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl_msf {

namespace {

constexpr int kLeaf = 12; // points

std::vector<float>
flatten (const std::vector<Eigen::Vector3f>& points)
{
  std::vector<float> coordinates;
  coordinates.reserve (3 * points.size());
  for (const auto& p : points)
    coordinates.insert (coordinates.end(), p.data(), p.data() + 3);
  return coordinates;
}

} // namespace

struct PointTree::Index {
  using Tree = flann::KDTreeSingleIndex<flann::L2_Simple<float>>;

  Index (std::vector<float> values, int columns)
  : dimensions (columns)
  , size (values.size() / columns)
  , coordinates (std::move (values))
  , tree (flann::Matrix<float> (coordinates.data(), size, columns),
          flann::KDTreeSingleIndexParams (kLeaf))
  {
    tree.buildIndex();
  }

  bool
  accepts (const float* query) const
  {
    return std::all_of (
        query, query + dimensions, [] (float v) { return std::isfinite (v); });
  }

  int dimensions;
  std::size_t size;
  std::vector<float> coordinates;
  Tree tree;
};

PointTree::PointTree() = default;
PointTree::~PointTree() = default;
PointTree::PointTree (PointTree&&) noexcept = default;
PointTree&
PointTree::operator= (PointTree&&) noexcept = default;

PointTree::PointTree (const std::vector<Eigen::Vector3f>& points)
: PointTree (flatten (points), 3)
{}

PointTree::PointTree (std::vector<float> coordinates, int dimensions)
{
  if (!coordinates.empty())
    index_ = std::make_unique<Index> (std::move (coordinates), dimensions);
}

FoundPoint
PointTree::nearest (const float* query) const
{
  if (!index_ || !index_->accepts (query))
    return {};
  flann::KNNSimpleResultSet<float> set (1);
  index_->tree.findNeighbors (set, query, flann::SearchParams (-1));
  std::size_t index = 0;
  float distance = 0.0f;
  set.copy (&index, &distance, 1);
  return {static_cast<int> (index), distance};
}

void
PointTree::nearest (const float* query,
                    int count,
                    std::vector<FoundPoint>& found) const
{
  found.clear();
  if (!index_ || count < 1 || !index_->accepts (query))
    return;
  const std::size_t wanted = std::min<std::size_t> (count, index_->size);
  thread_local std::vector<std::size_t> indices;
  thread_local std::vector<float> distances;
  indices.resize (wanted);
  distances.resize (wanted);
  flann::KNNSimpleResultSet<float> set (wanted);
  index_->tree.findNeighbors (set, query, flann::SearchParams (-1));
  set.copy (indices.data(), distances.data(), wanted);
  for (std::size_t i = 0; i < wanted; ++i)
    found.push_back ({static_cast<int> (indices[i]), distances[i]});
  std::sort (
      found.begin(), found.end(), [] (const FoundPoint& a, const FoundPoint& b) {
        return std::tie (a.squared_distance, a.index) <
               std::tie (b.squared_distance, b.index);
      });
}

} // namespace pcl_msf
