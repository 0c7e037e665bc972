// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/motion/motion_state.h"

#include <algorithm>

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
