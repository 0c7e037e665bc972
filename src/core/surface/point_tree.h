// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief A point found by a search. */
struct FoundPoint {
  int index{-1};
  float squared_distance{0.0f};
};

/** \brief A kd-tree over points of any dimension that keeps its own copy of them.
 * Searching is safe from several threads at once. */
class PointTree {
public:
  PointTree();
  explicit PointTree (const std::vector<Eigen::Vector3f>& points);
  PointTree (std::vector<float> coordinates, int dimensions);
  ~PointTree();
  PointTree (PointTree&&) noexcept;
  PointTree&
  operator= (PointTree&&) noexcept;

  /** \brief The nearest point; index -1 when there is none or the query is not finite.
   */
  FoundPoint
  nearest (const float* query) const;
  FoundPoint
  nearest (const Eigen::Vector3f& query) const
  {
    return nearest (query.data());
  }

  /** \brief The `count` nearest, nearest first; equal distances in the order of the
   * index. Fewer when there are fewer. */
  void
  nearest (const float* query, int count, std::vector<FoundPoint>& found) const;

private:
  struct Index;
  std::unique_ptr<Index> index_;
};

} // namespace pcl_msf
