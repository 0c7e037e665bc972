// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/common/point_tests.h>

#include <pcl_msf/lazy_kd_tree.h>

#include <algorithm>
#include <limits>

namespace pcl_msf {

template <typename PointT>
typename LazyKdTree<PointT>::Ptr
LazyKdTree<PointT>::copyOf (Base& other)
{
  auto copy = pcl::make_shared<LazyKdTree<PointT>>();
  copy->setSortedResults (other.getSortedResults());
  copy->setEpsilon (other.getEpsilon());
  copy->setPointRepresentation (other.getPointRepresentation());
  copy->setInputCloud (other.getInputCloud(), other.getIndices());
  if (const auto* lazy = dynamic_cast<const LazyKdTree<PointT>*> (&other)) {
    copy->depth_only_ = lazy->depth_only_;
    copy->query_origin_ = lazy->query_origin_;
    copy->query_axis_ = lazy->query_axis_;
  }
  return copy;
}

template <typename PointT>
void
LazyKdTree<PointT>::forgetTree()
{
  if (built_) {
    // A fresh inner tree: the old one would be rebuilt by setPointRepresentation.
    auto fresh = pcl::make_shared<pcl::KdTreeFLANN<PointT>> (this->sorted_results_);
    fresh->setEpsilon (this->tree_->getEpsilon());
    fresh->setPointRepresentation (this->tree_->getPointRepresentation());
    this->tree_ = fresh;
  }
  built_ = false;
}

template <typename PointT>
void
LazyKdTree<PointT>::setInputCloud (const PointCloudConstPtr& cloud,
                                   const pcl::IndicesConstPtr& indices)
{
  forgetTree();
  this->input_ = cloud;
  this->indices_ = indices;
}

template <typename PointT>
void
LazyKdTree<PointT>::setQueryCamera (const Eigen::Matrix<float, 4, 4>& cloud_from_query)
{
  query_axis_ = cloud_from_query.template block<3, 1> (0, 2);
  query_origin_ = cloud_from_query.template block<3, 1> (0, 3);
  if (!depth_only_)
    forgetTree(); // it may hold points without depth
  depth_only_ = true;
}

template <typename PointT>
void
LazyKdTree<PointT>::clearQueryCamera()
{
  if (depth_only_)
    forgetTree(); // it lacks points without depth
  depth_only_ = false;
}

template <typename PointT>
bool
LazyKdTree<PointT>::hasDepth (const PointT& query) const
{
  return pcl::isXYZFinite (query) &&
         (!depth_only_ ||
          query_axis_.dot (query.getVector3fMap() - query_origin_) > 0.0f);
}

template <typename PointT>
pcl::IndicesPtr
LazyKdTree<PointT>::findable() const
{
  auto found = pcl::make_shared<pcl::Indices>();
  if (!this->input_)
    return found;
  const auto size = static_cast<pcl::index_t> (this->input_->size());
  const auto take = [&] (pcl::index_t i) {
    if (i < 0 || i >= size) // the cloud may have become smaller
      return;
    const PointT& point = (*this->input_)[i];
    if (pcl::isXYZFinite (point) && (!depth_only_ || point.z > 0.0f))
      found->push_back (i);
  };
  if (this->indices_)
    std::for_each (this->indices_->begin(), this->indices_->end(), take);
  else
    for (pcl::index_t i = 0; i < size; ++i)
      take (i);
  return found;
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
  const pcl::IndicesPtr points = findable();
  has_points_ = !points->empty();
  if (has_points_) {
    const float epsilon = this->tree_->getEpsilon(); // which FLANN's tree forgets
    this->tree_->setInputCloud (this->input_, points);
    this->tree_->setEpsilon (epsilon);
  }
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
  if (k > 0 && hasDepth (point) && build())
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
  if (hasDepth (point) && build())
    return Base::radiusSearch (point, radius, k_indices, k_sqr_distances, max_nn);
  k_indices.clear();
  k_sqr_distances.clear();
  return 0;
}

} // namespace pcl_msf
