// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/search/kdtree.h>

#include <Eigen/Core>

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
 * setQueryCamera leaves out points without depth, too.
 *
 * The first query takes the cloud as it is then; after a change in place call
 * setInputCloud again, as every align does. Queries are safe from many threads; setters
 * are not.
 */
template <typename PointT>
class LazyKdTree : public pcl::search::KdTree<PointT> {
  using Base = pcl::search::KdTree<PointT>;

public:
  using Ptr = pcl::shared_ptr<LazyKdTree<PointT>>;
  using typename Base::PointCloudConstPtr;

  using Base::nearestKSearch;
  using Base::radiusSearch;

  /** \brief A tree of its own with the cloud and the settings of another one. */
  static Ptr
  copyOf (Base& other);

  /** \brief Remembers the cloud; forgets the tree of an earlier one. */
  void
  setInputCloud (const PointCloudConstPtr& cloud,
                 const pcl::IndicesConstPtr& indices = {}) override;

  /** \brief For clouds in a camera's optical frame, which may mark points without depth
   * by numbers such as (0, 0, 0): from now on only points of the cloud with z > 0 are
   * found, and queries that their own camera did not see in front of it find nothing.
   * \param cloud_from_query rigid: takes the frame of the camera that saw the query
   * points to the cloud's frame, in which queries are given */
  void
  setQueryCamera (const Eigen::Matrix<float, 4, 4>& cloud_from_query);

  /** \brief For clouds of no camera: from now on all finite points are found, and by
   * all finite queries, as at first. */
  void
  clearQueryCamera ();

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
  /** The points that can be found. */
  pcl::IndicesPtr
  findable () const;
  bool
  hasDepth (const PointT& query) const;
  void
  forgetTree ();

  bool depth_only_{false};                ///< is there a camera of queries?
  Eigen::Vector3f query_origin_{0, 0, 0}; ///< place of the camera that saw the queries
  Eigen::Vector3f query_axis_{0, 0, 1};   ///< and where it looked
  mutable std::mutex mutex_;
  mutable std::atomic<bool> built_{false};
  mutable bool has_points_{false};
};

} // namespace pcl_msf

#include <pcl_msf/impl/lazy_kd_tree.hpp>
