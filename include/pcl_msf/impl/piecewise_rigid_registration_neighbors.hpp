// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/errors.h>
#include <pcl_msf/impl/cloud_conversions.hpp>
#include <pcl_msf/impl/neighbor_registration.h>
#include <pcl_msf/impl/registration_steps.h>
#include <pcl_msf/impl/warp_cloud.hpp>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <algorithm>
#include <string>

/* How PiecewiseRigidRegistration works on clouds without a grid, and which those are.
 */
namespace pcl_msf {

namespace detail {

/** Lets width and height tell the size of a cloud that was filled through its vector of
 * points. */
template <typename PointT>
void
fitShape (pcl::PointCloud<PointT>& cloud)
{
  if (static_cast<std::size_t> (cloud.width) * cloud.height == cloud.size())
    return;
  cloud.width = static_cast<std::uint32_t> (cloud.size());
  cloud.height = 1;
}

/** Why the camera's way cannot take a cloud, and the remedy; empty when it can. */
template <typename PointT>
std::string
whyNoGrid (const pcl::PointCloud<PointT>& cloud, const std::string& name)
{
  if (isGrid (cloud))
    return {};
  return notOrganized (cloud, name) + "; clouds without a grid are registered by "
                                      "nearest neighbours: setCorrespondence "
                                      "(NearestNeighbor)";
}

} // namespace detail

template <typename PointT>
bool
PiecewiseRigidRegistration<PointT>::usesNeighbors() const
{
  if (correspondence_ != CorrespondenceMethod::Auto)
    return correspondence_ == CorrespondenceMethod::NearestNeighbor;
  // Of some of the targets, the misfit is told.
  return !detail::isGrid (*aligned_) ||
         (!targets_.empty() &&
          std::none_of (targets_.begin(), targets_.end(), [] (const auto& target) {
            return detail::isGrid (*target);
          }));
}

template <typename PointT>
detail::NeighborTask
PiecewiseRigidRegistration<PointT>::neighborTask (const pcl::Indices& points,
                                                  const Matrix4& guess) const
{
  detail::NeighborTask task;
  task.source = detail::allPoints (*aligned_);
  task.points = points;
  task.reference = reference_;
  task.constraints = constraints_;
  task.solver = getSolverParameters();
  task.multiframe = multiframe_;
  task.start = detail::startPose (guess);
  task.brightness_weight = (std::min) (energy_.brightness_weight, 1000.0);
  const bool bright = task.brightness_weight > 0.0;
  if (bright)
    task.brightness = detail::allBrightness (*aligned_);
  for (const PointCloudTargetConstPtr& target : targets_) {
    task.targets.push_back (detail::allPoints (*target));
    task.target_brightness.push_back (bright ? detail::allBrightness (*target)
                                             : std::vector<float>());
  }
  requireFittingNormals();
  if (normals_)
    task.normals = detail::pointNormals (*normals_);
  requireFittingLabels();
  if (labels_)
    task.labels = detail::pointLabels (*labels_);
  else if (!clusters_.empty())
    task.labels = detail::clusterLabels (clusters_, aligned_->size());
  return task;
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::matchNeighbors (const pcl::Indices& points,
                                                    const Matrix4& guess,
                                                    PointCloudSource& output)
{
  detail::NeighborTask task = neighborTask (points, guess);
  detail::GuardedProgress progress (task.solver.progress);
  task.solver.progress = progress.function();
  detail::NeighborRegistration found = detail::registerByNeighbors (task);
  progress.rethrow();
  result_ = std::move (found.flow);
  joints_ = std::move (found.joints);
  shown_ = detail::lastTarget (static_cast<int> (result_.frames.size()), reference_);
  detail::warpCloud (getSceneFlow(), points, output);
  const SceneFlow& flow = getSceneFlow();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int match = found.target[points[i]];
    if (match < 0 || flow.visibility.data[points[i]] != Visibility::Visible)
      continue;
    const float distance =
        (output[i].getVector3fMap() - (*this->target_)[match].getVector3fMap())
            .squaredNorm();
    this->correspondences_->emplace_back (points[i], match, distance);
  }
  publish();
}

} // namespace pcl_msf
