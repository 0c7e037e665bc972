// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/registration/registration.h>

#include <pcl_msf/lazy_kd_tree.h>

namespace pcl_msf {
namespace detail {

/** A pcl::Registration whose copies share nothing that an align changes. PCL's own
 * share correspondences, search objects and the list of all indices, through pointers,
 * and one that was moved from keeps its convergence. */
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
    this->setSearchMethodTarget (pcl::make_shared<LazyKdTree<PointT>>());
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
  /** The other one is left without clouds and without a result. */
  IndependentRegistration (IndependentRegistration&& other) : Base (other)
  {
    separate();
    other.forget();
  }
  IndependentRegistration&
  operator= (IndependentRegistration&& other)
  {
    if (this == &other)
      return *this;
    *this = static_cast<const IndependentRegistration&> (other);
    other.forget();
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
  void
  forget ()
  {
    this->input_ = pcl::make_shared<Cloud>();
    this->target_ = pcl::make_shared<Cloud>();
    this->source_cloud_updated_ = this->target_cloud_updated_ = true;
    this->indices_.reset();
    this->correspondences_->clear();
    this->final_transformation_ = this->transformation_ = Base::Matrix4::Identity();
    this->nr_iterations_ = 0;
    this->converged_ = false;
  }

public:
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

} // namespace detail
} // namespace pcl_msf
