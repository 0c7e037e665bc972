// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/console/print.h>

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/impl/registration_steps.h>
#include <pcl_msf/piecewise_rigid_tracker.h>

#include <limits>

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
    PCL_ERROR ("[pcl_msf::PiecewiseRigidTracker::setTrackerParameters] %s\n",
               why.c_str());
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
    const bool first = !reference_;
    if (first) {
      SegmentationParameters cut = segmentation_;
      if (rigid_)
        cut.method = SegmentationMethod::Single;
      tracker_ = SceneFlowTracker (parameters_, cut, energy_, solver_, multiframe_);
    }
    double unit = first ? 0.0 : intensity_unit_;
    const RgbdFrame frame =
        detail::makeFrames ({{coordinateImage (*cloud), colorImage (*cloud)}},
                            0,
                            first ? camera_ : used_camera_,
                            frame_,
                            cv::Mat(),
                            &unit)
            .front();
    const long reference = tracker_.firstFrame();
    tracker_.add (frame);
    used_camera_ = frame.camera();
    intensity_unit_ = unit;
    if (first)
      reference_ = cloud;
    else if (tracker_.firstFrame() != reference)
      reference_ = newest_;
    newest_ = cloud;
    return true;
  }
  catch (const std::exception& error) {
    PCL_ERROR ("[pcl_msf::PiecewiseRigidTracker::addCloud] %s\n", error.what());
    return false;
  }
}

template <typename PointT>
typename PiecewiseRigidTracker<PointT>::PointCloud
PiecewiseRigidTracker<PointT>::getWarpedCloud() const
{
  PointCloud warped;
  const SceneFlow& flow = getSceneFlow();
  if (flow.displacement.empty())
    return warped;
  warped = *reference_;
  for (int v = 0; v < flow.displacement.rows; ++v)
    for (int u = 0; u < flow.displacement.cols; ++u) {
      const auto& d = flow.displacement.template at<cv::Vec3f> (v, u);
      PointT& point = warped (u, v);
      point.getVector3fMap() += Eigen::Vector3f (d[0], d[1], d[2]);
      if (pcl::isXYZFinite (point))
        continue;
      point.getVector3fMap().setConstant (std::numeric_limits<float>::quiet_NaN());
      warped.is_dense = false;
    }
  return warped;
}

} // namespace pcl_msf
