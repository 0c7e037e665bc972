// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/registration/gicp.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "common/depth_points.h"
#include "common/methods/baselines.h"
#include "common/methods/lifting.h"
#include "common/stop_watch.h"

#include <cmath>

namespace pcl_msf::tool {

namespace {

constexpr double kMostPoints = 12000.0;

/** Every so many rows and columns that no more than kMostPoints are left. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
sparseCloud (const io::RgbdImages& images)
{
  const cv::Mat points = pointsOf (images);
  const auto pixels = static_cast<double> (points.total());
  const int step =
      std::max (1, static_cast<int> (std::ceil (std::sqrt (pixels / kMostPoints))));
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int y = step / 2; y < points.rows; y += step)
    for (int x = step / 2; x < points.cols; x += step) {
      const cv::Vec3f p = points.at<cv::Vec3f> (y, x);
      if (std::isfinite (p[2]))
        cloud->emplace_back (p[0], p[1], p[2]);
    }
  return cloud;
}

} // namespace

Estimate
ZeroFlow::run (const PairData& pair) const
{
  StopWatch watch;
  Estimate estimate;
  moveRigidly (pair, RigidPose{}, estimate);
  estimate.seconds.total = watch.lap();
  return estimate;
}

Estimate
Gicp::run (const PairData& pair) const
{
  StopWatch watch;
  Estimate estimate;
  pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> gicp;
  const auto source = sparseCloud (pair.reference), target = sparseCloud (pair.current);
  RigidPose pose;
  constexpr std::size_t kNeighbors = 20; // of PCL's covariances
  if (source->size() > kNeighbors && target->size() > kNeighbors) {
    gicp.setInputSource (source);
    gicp.setInputTarget (target);
    pcl::PointCloud<pcl::PointXYZ> aligned;
    gicp.align (aligned);
    pose = RigidPose::fromMatrix (Eigen::Matrix4f (gicp.getFinalTransformation()));
  }
  moveRigidly (pair, pose, estimate);
  estimate.seconds.total = watch.lap();
  return estimate;
}

} // namespace pcl_msf::tool
