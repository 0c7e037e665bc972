// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace pcl_msf {

/** \brief Disjoint sets of the numbers from 0; the smallest one of a set is its root,
 * whatever the order in which sets were joined. */
class DisjointSets {
public:
  explicit DisjointSets (int n) : parent_ (n)
  {
    std::iota (parent_.begin(), parent_.end(), 0);
  }

  /** \brief The root of a number's set. */
  int
  root (int i)
  {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  /** \brief Makes one set of those of two numbers. */
  void
  join (int a, int b)
  {
    a = root (a);
    b = root (b);
    parent_[std::max (a, b)] = std::min (a, b);
  }

private:
  std::vector<int> parent_;
};

} // namespace pcl_msf
