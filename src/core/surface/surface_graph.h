// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <limits>
#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief A step along a surface. */
struct SurfaceEdge {
  int to{0};
  float length{0.0f};
};

/** \brief Which points are neighbours along a surface: near is not enough, see
 * makeSurface. Both directions of an edge are there. */
class SurfaceGraph {
public:
  SurfaceGraph() = default;

  /** \param pairs first < second, each once */
  SurfaceGraph (const std::vector<Eigen::Vector3f>& points,
                std::vector<std::pair<int, int>> pairs);

  int
  size () const
  {
    return static_cast<int> (begin_.size()) - 1;
  }
  const SurfaceEdge*
  begin (int point) const
  {
    return edges_.data() + begin_[point];
  }
  const SurfaceEdge*
  end (int point) const
  {
    return edges_.data() + begin_[point + 1];
  }

  /** \brief Lowers distances along the surface to those from one more source.
   * \param[in,out] distances per point; infinity = not reached
   * \param visit (point, distance) for every point that got nearer */
  template <typename Visit>
  void
  spread (int source, std::vector<float>& distances, const Visit& visit) const;

  /** \brief Number of the connected piece of every point, largest piece first. */
  std::vector<int>
  pieces (std::vector<int>* sizes = nullptr) const;

  static constexpr float kUnreached = std::numeric_limits<float>::infinity();

private:
  std::vector<int> begin_{0};
  std::vector<SurfaceEdge> edges_;
};

} // namespace pcl_msf

#include "core/surface/surface_graph_impl.h"
