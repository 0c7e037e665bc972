// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/surface/surface_graph.h"

#include <algorithm>
#include <numeric>

namespace pcl_msf {

SurfaceGraph::SurfaceGraph (const std::vector<Eigen::Vector3f>& points,
                            std::vector<std::pair<int, int>> pairs)
{
  begin_.assign (points.size() + 1, 0);
  for (const auto& [a, b] : pairs) {
    ++begin_[a + 1];
    ++begin_[b + 1];
  }
  std::partial_sum (begin_.begin(), begin_.end(), begin_.begin());
  edges_.resize (2 * pairs.size());
  std::vector<int> next (begin_.begin(), begin_.end() - 1);
  std::sort (pairs.begin(), pairs.end());
  for (const auto& [a, b] : pairs) {
    const float length = (points[a] - points[b]).norm();
    edges_[next[a]++] = {b, length};
    edges_[next[b]++] = {a, length};
  }
}

std::vector<int>
SurfaceGraph::pieces (std::vector<int>* sizes) const
{
  std::vector<int> piece (size(), -1);
  std::vector<int> counts;
  std::vector<int> stack;
  for (int i = 0; i < size(); ++i) {
    if (piece[i] >= 0)
      continue;
    const int number = static_cast<int> (counts.size());
    counts.push_back (0);
    piece[i] = number;
    stack.assign (1, i);
    while (!stack.empty()) {
      const int p = stack.back();
      stack.pop_back();
      ++counts[number];
      for (const SurfaceEdge* e = begin (p); e != end (p); ++e)
        if (piece[e->to] < 0) {
          piece[e->to] = number;
          stack.push_back (e->to);
        }
    }
  }
  std::vector<int> order (counts.size());
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (order.begin(), order.end(), [&counts] (int a, int b) {
    return counts[a] > counts[b];
  });
  std::vector<int> rank (counts.size());
  for (std::size_t r = 0; r < order.size(); ++r)
    rank[order[r]] = static_cast<int> (r);
  for (int& p : piece)
    p = rank[p];
  if (sizes) {
    sizes->clear();
    for (const int number : order)
      sizes->push_back (counts[number]);
  }
  return piece;
}

} // namespace pcl_msf
