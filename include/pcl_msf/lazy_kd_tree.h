// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/search/kdtree.h>

#include <pcl_msf/build_compatibility.h>

#include <atomic>
#include <mutex>

namespace pcl_msf {

/** \brief A kd-tree that is built by the first query, not by setInputCloud.
 *
 * pcl::Registration hands its target to a kd-tree in every align; an image-based method
 * never asks that tree anything, and building it costs about as much as a level of the
 * solve (48 ms for 446 k points). This one keeps the cloud and waits.
 *
 * Queries at points that are not finite, and queries to a cloud without finite points,
 * find nothing: they return 0 and fill the results with index -1 at infinite distance,
 * so that code which reads the first entry without looking at the count sees "too far".
 *
 * Queries are safe from many threads; setInputCloud is not.
 */
template <typename PointT>
class LazyKdTree : public pcl::search::KdTree<PointT> {
  using Base = pcl::search::KdTree<PointT>;

public:
  using Ptr = pcl::shared_ptr<LazyKdTree<PointT>>;
  using typename Base::PointCloudConstPtr;

  using Base::nearestKSearch;
  using Base::radiusSearch;

  /** \brief Remembers the cloud; forgets the tree of an earlier one. */
  void
  setInputCloud (const PointCloudConstPtr& cloud,
                 const pcl::IndicesConstPtr& indices = {}) override;

  int
  nearestKSearch (const PointT& point,
                  int k,
                  pcl::Indices& k_indices,
                  std::vector<float>& k_sqr_distances) const override;

  int
  radiusSearch (const PointT& point,
                double radius,
                pcl::Indices& k_indices,
                std::vector<float>& k_sqr_distances,
                unsigned int max_nn = 0) const override;

  /** \brief Has a query built the tree of the present cloud? */
  bool
  isBuilt () const
  {
    return built_;
  }

private:
  /** Builds on first use. \return can anything be found? */
  bool
  build () const;

  mutable std::mutex mutex_;
  mutable std::atomic<bool> built_{false};
  mutable bool has_points_{false};
};

} // namespace pcl_msf

#include <pcl_msf/impl/lazy_kd_tree.hpp>
