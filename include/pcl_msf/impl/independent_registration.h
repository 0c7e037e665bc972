// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/registration/registration.h>

#include <pcl_msf/lazy_kd_tree.h>

namespace pcl_msf {
namespace detail {

/** A pcl::Registration whose copies share nothing that an align changes. PCL's own
 * share correspondences, search objects and the list of all indices, through pointers.
 */
template <typename PointT>
class IndependentRegistration : public pcl::Registration<PointT, PointT, float> {
  using Base = pcl::Registration<PointT, PointT, float>;
  using Cloud = pcl::PointCloud<PointT>;

public:
  IndependentRegistration()
  {
    // Empty clouds, not null ones: PCL's non-virtual functions dereference them.
    this->input_ = pcl::make_shared<Cloud>();
    this->target_ = pcl::make_shared<Cloud>();
    // PCL hands both clouds to its search objects in every align: lazy ones cost
    // nothing.
    const auto tree = pcl::make_shared<LazyKdTree<PointT>>();
    tree->setQueryCamera (Eigen::Matrix4f::Identity());
    this->setSearchMethodTarget (tree);
    this->setSearchMethodSource (pcl::make_shared<LazyKdTree<PointT>>());
  }
  IndependentRegistration (const IndependentRegistration& other) : Base (other)
  {
    separate();
  }
  IndependentRegistration&
  operator= (const IndependentRegistration& other)
  {
    Base::operator= (other);
    separate();
    return *this;
  }

private:
  void
  separate ()
  {
    this->correspondences_ =
        pcl::make_shared<pcl::Correspondences> (*this->correspondences_);
    // One that is never recomputed may be shared.
    if (this->tree_ && !this->force_no_recompute_)
      this->tree_ = LazyKdTree<PointT>::copyOf (*this->tree_);
    if (this->tree_reciprocal_ && !this->force_no_recompute_reciprocal_)
      this->tree_reciprocal_ = LazyKdTree<PointT>::copyOf (*this->tree_reciprocal_);
    this->correspondence_estimation_.reset(); // not used, but written to by every align
    this->indices_.reset();                   // the next align makes them anew
  }

public:
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

} // namespace detail
} // namespace pcl_msf
