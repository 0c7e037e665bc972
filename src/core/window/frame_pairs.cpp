// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/window/frame_pairs.h"

#include <cstdlib>

namespace pcl_msf {

FramePairs::FramePairs (int frames, int reference)
: frames_ (frames)
, reference_ (reference)
, index_ (static_cast<std::size_t> (frames) * frames, -1)
{
  for (int a = 0; a < frames; ++a)
    for (int b = a + 1; b < frames; ++b) {
      const bool backward = b <= reference;
      index_[a * frames + b] = index_[b * frames + a] = count();
      pairs_.push_back ({backward ? b : a, backward ? a : b, b == a + 1});
    }
}

std::vector<FramePairs::Step>
FramePairs::chain (int pair) const
{
  std::vector<Step> steps;
  const Pair& p = pairs_[pair];
  const int direction = p.to > p.from ? 1 : -1;
  for (int at = p.from; at != p.to; at += direction) {
    const int step = between (at, at + direction);
    steps.push_back ({step, pairs_[step].from != at});
  }
  return steps;
}

std::vector<int>
FramePairs::outwards() const
{
  std::vector<int> order;
  for (int k = reference_; k < frames_; ++k)
    order.push_back (k);
  for (int k = reference_ - 1; k >= 0; --k)
    order.push_back (k);
  return order;
}

} // namespace pcl_msf
