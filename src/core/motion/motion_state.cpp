// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/motion/motion_state.h"

#include "core/base/disjoint_sets.h"

#include <algorithm>
#include <numeric>

namespace pcl_msf {

std::vector<int>
WindowState::renumberBodies()
{
  std::vector<int> index (bodies(), -1);
  std::vector<int> before;
  for (int& body : body_of) {
    if (index[body] < 0) {
      index[body] = static_cast<int> (before.size());
      before.push_back (body);
    }
    body = index[body];
  }
  for (auto& of_pair : poses) {
    std::vector<RigidPose> kept;
    for (const int body : before)
      kept.push_back (of_pair[body]);
    of_pair.swap (kept);
  }
  return before;
}

void
WindowState::joinEqualPoses (const std::vector<SegmentLink>& links,
                             const std::vector<char>& alone)
{
  DisjointSets together (bodies());
  const auto equal = [this] (int a, int b) {
    return std::all_of (poses.begin(), poses.end(), [a, b] (const auto& of_pair) {
      return of_pair.empty() || of_pair[a].parameters == of_pair[b].parameters;
    });
  };
  for (const SegmentLink& link : links) {
    if (!alone.empty() && (alone[link.first] != 0 || alone[link.second] != 0))
      continue;
    const int a = body_of[link.first];
    const int b = body_of[link.second];
    if (a != b && equal (a, b))
      together.join (a, b);
  }
  for (int& body : body_of)
    body = together.root (body);
  renumberBodies();
}

void
WindowState::separate()
{
  for (std::vector<RigidPose>& of_pair : poses) {
    if (of_pair.empty())
      continue;
    std::vector<RigidPose> of_segment;
    for (const int body : body_of)
      of_segment.push_back (of_pair[body]);
    of_pair = std::move (of_segment);
  }
  std::iota (body_of.begin(), body_of.end(), 0);
}

int
WindowState::largestBody() const
{
  std::vector<int> segments (bodies(), 0);
  for (const int body : body_of)
    ++segments[body];
  return static_cast<int> (std::max_element (segments.begin(), segments.end()) -
                           segments.begin());
}

} // namespace pcl_msf
