// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/impl/registration_steps.h>
#include <pcl_msf/impl/warp_cloud.hpp>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cmath>
#include <limits>
#include <string>

/* What PiecewiseRigidRegistration gives back besides align's cloud. */
namespace pcl_msf {

template <typename PointT>
const SceneFlow&
PiecewiseRigidRegistration<PointT>::getSceneFlow (int frame) const
{
  if (frame >= 0 && frame < static_cast<int> (result_.frames.size()))
    return result_.frames[frame];
  printError ("getSceneFlow", "the last align had no such frame");
  return detail::noSceneFlow();
}

template <typename PointT>
const std::vector<CloudJoint>&
PiecewiseRigidRegistration<PointT>::getJoints (int frame) const
{
  const auto frames = static_cast<int> (result_.frames.size());
  if (frame < 0 || frame >= frames)
    printError ("getJoints", "the last align had no such frame");
  else if (!joints_.empty())
    return joints_[frame];
  return detail::noJoints();
}

template <typename PointT>
typename PiecewiseRigidRegistration<PointT>::PointCloudSource
PiecewiseRigidRegistration<PointT>::getWarpedCloud (int frame) const
{
  const SceneFlow& flow = getSceneFlow (frame);
  const bool own = frame == result_.reference && !result_.frames.empty();
  if (!aligned_ || flow.displacement.total() != aligned_->size())
    return own && aligned_ ? *aligned_ : PointCloudSource();
  return detail::warpedCloud (flow, *aligned_);
}

template <typename PointT>
typename PiecewiseRigidRegistration<PointT>::Matrix4
PiecewiseRigidRegistration<PointT>::getPose (int from, int to, int segment) const
{
  RigidPose pose;
  const std::string why = detail::findPose (result_, from, to, segment, pose);
  if (!why.empty())
    printError ("getPose", why);
  return pose.matrix();
}

template <typename PointT>
double
PiecewiseRigidRegistration<PointT>::getFitnessScore (double max_range)
{
  double sum = 0.0;
  std::size_t n = 0;
  for (const auto& pair : *this->correspondences_)
    if (pair.distance <= max_range) {
      sum += pair.distance;
      ++n;
    }
  return n > 0 ? sum / static_cast<double> (n) : (std::numeric_limits<double>::max)();
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::showResult (const PointCloudSource& warped,
                                                const pcl::Indices& points) const
{
  if (!this->update_visualizer_)
    return;
  // Correspondences are in the output's order, but name the source's points.
  const auto& pairs = *this->correspondences_;
  pcl::Indices shown;
  pcl::Indices matches;
  for (std::size_t i = 0; i < warped.size() && shown.size() < pairs.size(); ++i)
    if (pairs[shown.size()].index_query == points[i]) {
      matches.push_back (pairs[shown.size()].index_match);
      shown.push_back (static_cast<pcl::index_t> (i));
    }
  try {
    this->update_visualizer_ (warped, shown, *this->target_, matches);
  }
  catch (const std::exception& error) {
    printError ("align", std::string ("visualization callback: ") + error.what());
  }
  catch (...) {
    printError ("align", "the visualization callback threw");
  }
}

template <typename PointT>
void
PiecewiseRigidRegistration<PointT>::findCorrespondences (const PointCloudSource& warped,
                                                         const pcl::Indices& points)
{
  const SceneFlow& flow = getSceneFlow();
  const cv::Size size = flow.visibility.size();
  this->correspondences_->reserve (warped.size());
  for (std::size_t i = 0; i < warped.size(); ++i) {
    const int index = points[i];
    const auto seen = flow.visibility.template at<unsigned char> (index / size.width,
                                                                  index % size.width);
    if (seen != Visibility::Visible)
      continue;
    const Eigen::Vector3f point = warped[i].getVector3fMap();
    const int match = detail::pixelOf (point, flow.camera, size);
    if (match < 0 || !detail::hasDepth ((*this->target_)[match]))
      continue;
    const float distance =
        (point - (*this->target_)[match].getVector3fMap()).squaredNorm();
    this->correspondences_->emplace_back (index, match, distance);
  }
}

} // namespace pcl_msf
