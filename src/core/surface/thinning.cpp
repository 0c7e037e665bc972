// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/surface/thinning.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace pcl_msf {

namespace {

constexpr int kTrials = 6; // of the cube's size

/** 0 .. 5: the axis that a normal goes along most, and its sign. */
std::uint64_t
sideOf (const Eigen::Vector3f& normal)
{
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff (&axis);
  return 2 * static_cast<std::uint64_t> (axis) + (normal[axis] < 0.0f ? 1 : 0);
}

/** One point of each cube and side, the first. */
std::vector<int>
firstOfCubes (const std::vector<Eigen::Vector3f>& points,
              const std::vector<Eigen::Vector3f>& normals,
              const Eigen::Vector3f& low,
              float cube)
{
  std::vector<std::pair<std::uint64_t, int>> keys;
  keys.reserve (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f cell = (points[i] - low) / cube;
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k)
      key = key << 20U | static_cast<std::uint64_t> (cell[k]);
    key = key << 3U | (normals.empty() ? 0 : sideOf (normals[i]));
    keys.emplace_back (key, static_cast<int> (i));
  }
  std::sort (keys.begin(), keys.end());
  std::vector<int> kept;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (i == 0 || keys[i].first != keys[i - 1].first)
      kept.push_back (keys[i].second);
  std::sort (kept.begin(), kept.end());
  return kept;
}

} // namespace

std::vector<int>
thinPoints (const std::vector<Eigen::Vector3f>& points,
            const std::vector<Eigen::Vector3f>& normals,
            int count)
{
  std::vector<int> kept (points.size());
  std::iota (kept.begin(), kept.end(), 0);
  if (static_cast<int> (points.size()) <= count)
    return kept;
  Eigen::Vector3f low = points[0];
  Eigen::Vector3f high = points[0];
  for (const auto& p : points) {
    low = low.cwiseMin (p);
    high = high.cwiseMax (p);
  }
  const float size = (high - low).maxCoeff();
  float cube = size / std::sqrt (static_cast<float> (count));
  for (int trial = 0; trial < kTrials; ++trial) {
    cube = std::max (cube, size * 2e-6f); // 20 bits a coordinate
    kept = firstOfCubes (points, normals, low, cube);
    const double ratio = static_cast<double> (kept.size()) / count;
    if (ratio > 0.9 && ratio < 1.1)
      break;
    cube *= static_cast<float> (std::sqrt (ratio)); // a surface
  }
  return kept;
}

std::vector<int>
spreadPoints (const std::vector<Eigen::Vector3f>& points,
              const std::vector<int>& chosen,
              int count)
{
  std::vector<int> places;
  std::vector<float> distance (chosen.size(), std::numeric_limits<float>::infinity());
  std::size_t next = 0;
  while (static_cast<int> (places.size()) < count && next < chosen.size()) {
    places.push_back (static_cast<int> (next));
    const Eigen::Vector3f& p = points[chosen[next]];
    for (std::size_t i = 0; i < chosen.size(); ++i)
      distance[i] = std::min (distance[i], (points[chosen[i]] - p).squaredNorm());
    next = std::max_element (distance.begin(), distance.end()) - distance.begin();
    if (!(distance.empty() || distance[next] > 0.0f))
      break;
  }
  return places;
}

} // namespace pcl_msf
