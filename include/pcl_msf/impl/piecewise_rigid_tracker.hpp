// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/impl/registration_steps.h>
#include <pcl_msf/impl/warp_cloud.hpp>
#include <pcl_msf/piecewise_rigid_tracker.h>

namespace pcl_msf {

template <typename PointT>
void
PiecewiseRigidTracker<PointT>::setTrackerParameters (
    const TrackerParameters& parameters)
{
  std::string why;
  if (parameters.isValid (&why))
    parameters_ = parameters;
  else
    printError ("setTrackerParameters", why);
}

template <typename PointT>
void
PiecewiseRigidTracker<PointT>::restart()
{
  reference_.reset();
  newest_.reset();
  tracker_ = SceneFlowTracker();
}

template <typename PointT>
bool
PiecewiseRigidTracker<PointT>::addCloud (const PointCloudConstPtr& cloud)
{
  try {
    if (!cloud || cloud->empty())
      throw InvalidInput ("the cloud is empty: give an organized one");
    requireOrganized (*cloud, "cloud");
    const auto kept = pcl::make_shared<PointCloud> (*cloud); // it may be filled anew
    const bool first = !reference_;
    if (first)
      tracker_ =
          SceneFlowTracker (parameters_, segmentation_, energy_, solver_, multiframe_);
    double unit = first ? 0.0 : intensity_unit_;
    const RgbdFrame frame =
        detail::makeFrames ({{coordinateImage (*kept), colorImage (*kept)}},
                            0,
                            first ? camera_ : used_camera_,
                            frame_,
                            cv::Mat(),
                            &unit)
            .front();
    const long reference = tracker_.firstFrame();
    tracker_.add (frame);
    used_camera_ = frame.inputCamera();
    intensity_unit_ = unit;
    if (first)
      reference_ = kept;
    else if (tracker_.firstFrame() != reference)
      reference_ = newest_;
    newest_ = kept;
    return true;
  }
  catch (const std::exception& error) {
    printError ("addCloud", error.what());
    return false;
  }
}

template <typename PointT>
typename PiecewiseRigidTracker<PointT>::PointCloud
PiecewiseRigidTracker<PointT>::getWarpedCloud() const
{
  const SceneFlow& flow = getSceneFlow();
  return flow.displacement.empty() || !reference_
             ? PointCloud()
             : detail::warpedCloud (flow, *reference_);
}

} // namespace pcl_msf
