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
template <typename CloudPtr>
void
PiecewiseRigidRegistration<PointT>::setInputTargets (
    const std::vector<CloudPtr>& clouds)
{
  setInputTargets (
      std::vector<PointCloudTargetConstPtr> (clouds.begin(), clouds.end()));
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

/* PCL's align copies the indexed points before any of our code runs, and the source can
 * be filled anew by then: the base never gets the indices, it works on all points. */

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setIndices (const pcl::IndicesPtr& indices)
{
  selection_ = indices ? detail::PointSelection (*indices) : detail::PointSelection();
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setIndices (const pcl::IndicesConstPtr& indices)
{
  selection_ = indices ? detail::PointSelection (*indices) : detail::PointSelection();
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setIndices (
    const pcl::PointIndicesConstPtr& indices)
{
  selection_ =
      indices ? detail::PointSelection (indices->indices) : detail::PointSelection();
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setIndices (std::size_t row_start,
                                                std::size_t col_start,
                                                std::size_t nb_rows,
                                                std::size_t nb_cols)
{
  if (nb_rows > 0 && nb_cols > 0)
    selection_ = detail::PointSelection (row_start, col_start, nb_rows, nb_cols);
  else
    printError ("setIndices", "the rectangle is empty: give one of the source");
}

template <typename PointT>
pcl::IndicesPtr
PiecewiseRigidRegistration<PointT>::getIndices() const
{
  if (selection_.isAll())
    return this->indices_;
  auto points = pcl::make_shared<pcl::Indices>();
  const PointCloudSource& source = *this->input_;
  selection_.find (source.width, source.height, source.size(), *points);
  return points;
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::setKnownCorrespondences (
    const pcl::Correspondences& correspondences, const std::vector<double>& weights)
{
  CloudConstraints constraints = constraints_;
  constraints.pairs.clear();
  std::string why;
  if (!weights.empty() && weights.size() != correspondences.size())
    why = "weights must be as many as pairs, or none";
  for (std::size_t i = 0; i < correspondences.size() && why.empty(); ++i)
    constraints.pairs.push_back ({correspondences[i].index_query,
                                  correspondences[i].index_match,
                                  weights.empty() ? 1.0 : weights[i]});
  if (why.empty() && constraints.isValid (&why))
    constraints_ = constraints;
  else
    printError ("setKnownCorrespondences", why);
}

template <typename PointT>
pcl::Correspondences
PiecewiseRigidRegistration<PointT>::getKnownCorrespondences() const
{
  pcl::Correspondences correspondences;
  for (const KnownPair& pair : constraints_.pairs)
    correspondences.emplace_back (
        pair.source, pair.target, static_cast<float> (pair.weight));
  return correspondences;
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
