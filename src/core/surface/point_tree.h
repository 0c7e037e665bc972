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

/** \brief A tree of boxes over points of up to eight dimensions that keeps its own
 * copy of them.
 *
 * Unlike a kd-tree's planes its boxes can follow points that move, and a search can
 * begin at a point that is likely: both are what iterated matching needs. What is found
 * depends on the points alone; of equal distances it is the lower index. Searching is
 * safe from several threads at once. */
class PointTree {
public:
  PointTree();
  explicit PointTree (const std::vector<Eigen::Vector3f>& points);
  /** \param coordinates finite, point by point */
  PointTree (const std::vector<float>& coordinates, int dimensions);
  ~PointTree();
  PointTree (PointTree&&) noexcept;
  PointTree&
  operator= (PointTree&&) noexcept;

  int
  size () const;

  /** \brief Puts the same number of points elsewhere. They stay divided as they are:
   * searches take longer the more points have left their neighbours. */
  void
  move (const std::vector<float>& coordinates);

  /** \brief The nearest point; index -1 when there is none or the query is not finite.
   * \param hint a point that may be near, -1 = none: saves time, changes nothing */
  FoundPoint
  nearest (const float* query, int hint = -1) const;
  FoundPoint
  nearest (const Eigen::Vector3f& query) const
  {
    return nearest (query.data());
  }

  /** \brief The `count` nearest, nearest first. Fewer when there are fewer. */
  void
  nearest (const float* query, int count, std::vector<FoundPoint>& found) const;

private:
  struct Boxes;
  std::unique_ptr<Boxes> boxes_;
};

} // namespace pcl_msf
