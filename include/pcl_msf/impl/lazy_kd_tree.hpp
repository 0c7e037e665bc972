// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/common/point_tests.h>

#include <pcl_msf/lazy_kd_tree.h>

#include <algorithm>
#include <limits>

namespace pcl_msf {

template <typename PointT>
void
LazyKdTree<PointT>::setInputCloud (const PointCloudConstPtr& cloud,
                                   const pcl::IndicesConstPtr& indices)
{
  if (built_) {
    // A fresh inner tree: the old one would be rebuilt by setPointRepresentation.
    auto fresh = pcl::make_shared<pcl::KdTreeFLANN<PointT>> (this->sorted_results_);
    fresh->setEpsilon (this->tree_->getEpsilon());
    fresh->setPointRepresentation (this->tree_->getPointRepresentation());
    this->tree_ = fresh;
  }
  this->input_ = cloud;
  this->indices_ = indices;
  built_ = false;
}

template <typename PointT>
bool
LazyKdTree<PointT>::build() const
{
  if (built_)
    return has_points_;
  const std::lock_guard<std::mutex> lock (mutex_);
  if (built_)
    return has_points_;
  const auto finite = [] (const PointT& p) { return pcl::isXYZFinite (p); };
  const auto& cloud = this->input_;
  has_points_ = cloud && std::any_of (cloud->begin(), cloud->end(), finite);
  if (has_points_)
    this->tree_->setInputCloud (cloud, this->indices_);
  built_ = true;
  return has_points_;
}

template <typename PointT>
int
LazyKdTree<PointT>::nearestKSearch (const PointT& point,
                                    int k,
                                    pcl::Indices& k_indices,
                                    std::vector<float>& k_sqr_distances) const
{
  if (k > 0 && pcl::isXYZFinite (point) && build())
    return Base::nearestKSearch (point, k, k_indices, k_sqr_distances);
  k_indices.assign ((std::max) (k, 0), -1);
  k_sqr_distances.assign ((std::max) (k, 0), std::numeric_limits<float>::infinity());
  return 0;
}

template <typename PointT>
int
LazyKdTree<PointT>::radiusSearch (const PointT& point,
                                  double radius,
                                  pcl::Indices& k_indices,
                                  std::vector<float>& k_sqr_distances,
                                  unsigned int max_nn) const
{
  if (pcl::isXYZFinite (point) && build())
    return Base::radiusSearch (point, radius, k_indices, k_sqr_distances, max_nn);
  k_indices.clear();
  k_sqr_distances.clear();
  return 0;
}

} // namespace pcl_msf
