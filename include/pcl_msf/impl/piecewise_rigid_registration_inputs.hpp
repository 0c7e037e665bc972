// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/piecewise_rigid_registration.h>

/* What goes into PiecewiseRigidRegistration: clouds, indices, solver settings. */
namespace pcl_msf {

template <typename PointT>
PiecewiseRigidRegistration<PointT>::PiecewiseRigidRegistration()
{
  this->reg_name_ = "PiecewiseRigidRegistration";
  this->max_iterations_ = SolverParameters{}.max_iterations;
  // PCL hands both clouds to its search objects in every align: lazy ones cost nothing.
  this->setSearchMethodTarget (pcl::make_shared<LazyKdTree<PointT>>());
  this->setSearchMethodSource (pcl::make_shared<LazyKdTree<PointT>>());
  // Empty clouds instead of null ones: PCL's non-virtual functions dereference them.
  this->input_ = pcl::make_shared<PointCloudSource>();
  this->target_ = pcl::make_shared<PointCloudSource>();
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setInputSource (
    const PointCloudSourceConstPtr& cloud)
{
  if (cloud && !cloud->empty())
    Base::setInputSource (cloud);
  else {
    printError ("setInputSource", "the source is empty: give an organized cloud");
    this->input_ = pcl::make_shared<PointCloudSource>();
    this->converged_ = false;
  }
  adoptIndices();
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setInputTarget (
    const PointCloudTargetConstPtr& cloud)
{
  clearInputTargets();
  if (cloud && !cloud->empty())
    addInputTarget (cloud);
  else
    printError ("setInputTarget", "the target is empty: give an organized cloud");
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::addInputTarget (
    const PointCloudTargetConstPtr& cloud)
{
  if (!cloud || cloud->empty()) {
    printError ("addInputTarget", "the target is empty: give an organized cloud");
    return;
  }
  Base::setInputTarget (cloud); // what the base's functions compare with: the last one
  targets_.push_back (cloud);
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setInputTargets (
    const std::vector<PointCloudTargetConstPtr>& clouds)
{
  clearInputTargets();
  for (const PointCloudTargetConstPtr& cloud : clouds)
    if (!cloud || cloud->empty()) {
      printError ("setInputTargets", "a target is empty: give organized clouds");
      return;
    }
  for (const PointCloudTargetConstPtr& cloud : clouds)
    addInputTarget (cloud);
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::clearInputTargets()
{
  targets_.clear();
  this->target_ = pcl::make_shared<PointCloudSource>();
  this->target_cloud_updated_ = true;
  this->converged_ = false;
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setReferenceFrame (int frame)
{
  if (frame < 0) {
    printError ("setReferenceFrame", "the reference frame must be >= 0");
    return;
  }
  reference_ = frame;
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setIndices (const pcl::IndicesPtr& indices)
{
  requested_indices_ = indices;
  adoptIndices();
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setIndices (const pcl::IndicesConstPtr& indices)
{
  setIndices (indices ? pcl::make_shared<pcl::Indices> (*indices) : pcl::IndicesPtr());
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setIndices (
    const pcl::PointIndicesConstPtr& indices)
{
  setIndices (indices ? pcl::make_shared<pcl::Indices> (indices->indices)
                      : pcl::IndicesPtr());
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setIndices (std::size_t row_start,
                                                std::size_t col_start,
                                                std::size_t nb_rows,
                                                std::size_t nb_cols)
{
  const std::size_t width = this->input_->width;
  const std::size_t height = this->input_->height;
  if (nb_rows == 0 || nb_cols == 0 || row_start > height || col_start > width ||
      nb_rows > height - row_start || nb_cols > width - col_start) {
    printError (
        "setIndices",
        "the rectangle is empty or not inside the source; set the source first");
    return;
  }
  auto indices = pcl::make_shared<pcl::Indices>();
  indices->reserve (nb_rows * nb_cols);
  for (std::size_t v = row_start; v < row_start + nb_rows; ++v)
    for (std::size_t u = col_start; u < col_start + nb_cols; ++u)
      indices->push_back (static_cast<pcl::index_t> (v * width + u));
  setIndices (pcl::IndicesPtr (indices));
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::adoptIndices()
{
  // align copies the indexed points before any of our code runs: only indices that fit
  // the source may reach it. Source and indices can come in either order.
  const auto size = static_cast<pcl::index_t> (this->input_->size());
  indices_fit_ = true;
  if (requested_indices_)
    for (const auto index : *requested_indices_)
      indices_fit_ = indices_fit_ && index >= 0 && index < size;
  Base::setIndices (indices_fit_ ? requested_indices_
                                 : pcl::make_shared<pcl::Indices>());
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setMaximumIterations (int iterations)
{
  SolverParameters parameters = getSolverParameters();
  parameters.max_iterations = iterations;
  if (takeSolverParameters (parameters, "setMaximumIterations"))
    this->max_iterations_ = iterations;
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setSolverParameters (
    const SolverParameters& parameters)
{
  if (takeSolverParameters (parameters, "setSolverParameters"))
    this->max_iterations_ = parameters.max_iterations;
}

template <typename PointT>
SolverParameters
PiecewiseRigidRegistration<PointT>::getSolverParameters() const
{
  SolverParameters parameters = solver_;
  parameters.max_iterations = this->max_iterations_; // a base pointer sets only this
  return parameters;
}

} // namespace pcl_msf
