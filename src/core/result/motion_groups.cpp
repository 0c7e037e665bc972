// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/motion_groups.h"

#include "core/base/disjoint_sets.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_msf {

namespace {

/** Joins bodies over surviving connections, and small ones that a soft surface bridges:
 * motion groups. Joints of large rigid bodies stay apart. */
std::vector<int>
groupBodies (const MotionState& state,
             const std::vector<SegmentPair>& pairs,
             const GroupTuning& tuning)
{
  DisjointSets groups (static_cast<int> (state.poses.size()));
  std::vector<int> segments (state.poses.size(), 0);
  for (const int b : state.body_of)
    ++segments[b];
  const auto small = [&] (int segment) {
    return segments[state.body_of[segment]] <= tuning.small_body;
  };
  for (const SegmentPair& pair : pairs)
    if (pair.weight >= tuning.together ||
        (pair.mixing >= tuning.soft && small (pair.first) && small (pair.second)))
      groups.join (state.body_of[pair.first], state.body_of[pair.second]);
  std::vector<int> group_of (state.poses.size());
  for (std::size_t b = 0; b < group_of.size(); ++b)
    group_of[b] = groups.root (static_cast<int> (b));
  return group_of;
}

/** Points that are seen in the current frame, all points: of two, the larger one is
 * what more is known of. */
using Size = std::pair<int, int>;

/** Per body or group. */
std::vector<Size>
countPoints (const std::vector<SegmentMotion>& segments, const std::vector<int>& of)
{
  std::vector<Size> sizes (of.empty() ? 0
                                      : 1 + *std::max_element (of.begin(), of.end()));
  for (std::size_t k = 0; k < segments.size(); ++k) {
    sizes[of[k]].first += segments[k].visible_points;
    sizes[of[k]].second += segments[k].points;
  }
  return sizes;
}

} // namespace

void
numberGroups (const MotionState& state, const GroupTuning& tuning, SceneFlow& result)
{
  const std::vector<int> group_of_body = groupBodies (state, result.pairs, tuning);
  std::vector<int> group_of (state.body_of.size());
  for (std::size_t k = 0; k < group_of.size(); ++k)
    group_of[k] = group_of_body[state.body_of[k]];
  const std::vector<Size> sizes = countPoints (result.segments, group_of);
  std::vector<int> order (sizes.size());
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (
      order.begin(), order.end(), [&] (int a, int b) { return sizes[a] > sizes[b]; });
  std::vector<int> rank (sizes.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    rank[order[i]] = static_cast<int> (i);
  const std::vector<Size> body_sizes = countPoints (result.segments, state.body_of);
  int largest = -1;
  for (std::size_t k = 0; k < group_of.size(); ++k) {
    result.segments[k].group = rank[group_of[k]];
    result.groups = std::max (result.groups, result.segments[k].group + 1);
    const int body = state.body_of[k];
    if (result.segments[k].group == 0 &&
        (largest < 0 || body_sizes[body] > body_sizes[largest]))
      largest = body;
  }
  result.dominant_group = largest < 0 ? -1 : 0;
  if (largest >= 0)
    result.dominant_motion = state.poses[largest];
}

} // namespace pcl_msf
