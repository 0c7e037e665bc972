// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <functional>
#include <queue>

namespace pcl_msf {

template <typename Visit>
void
SurfaceGraph::spread (int source,
                      std::vector<float>& distances,
                      const Visit& visit) const
{
  using Front = std::pair<float, int>;
  std::priority_queue<Front, std::vector<Front>, std::greater<Front>> queue;
  if (distances[source] > 0.0f) {
    distances[source] = 0.0f;
    queue.push ({0.0f, source});
  }
  while (!queue.empty()) {
    const auto [distance, point] = queue.top();
    queue.pop();
    if (distance > distances[point])
      continue;
    if (!visit (point, distance))
      continue;
    for (const SurfaceEdge* e = begin (point); e != end (point); ++e)
      if (distance + e->length < distances[e->to]) {
        distances[e->to] = distance + e->length;
        queue.push ({distances[e->to], e->to});
      }
  }
}

} // namespace pcl_msf
