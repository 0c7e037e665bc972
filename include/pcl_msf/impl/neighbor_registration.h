// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>
#include <pcl/types.h>

#include <opencv2/core.hpp>

#include <pcl_msf/cloud_constraints.h>
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/cloud_flow.h>
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/export.h>
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/parameters.h>

#include <cstddef>
#include <limits>
#include <vector>

/* What PiecewiseRigidRegistration does with clouds that have no grid: compiled once,
 * not part of the public interface. */
namespace pcl_msf {
namespace detail {

/** CV_32FC3 of a cloud of any shape; NaN = no point. */
template <typename PointT>
cv::Mat
allPoints (const pcl::PointCloud<PointT>& cloud)
{
  const bool shaped =
      static_cast<std::size_t> (cloud.width) * cloud.height == cloud.size();
  cv::Mat image (shaped ? static_cast<int> (cloud.height) : 1,
                 static_cast<int> (shaped ? cloud.width : cloud.size()),
                 CV_32FC3);
  auto* points = image.ptr<cv::Vec3f> (0);
  for (const PointT& p : cloud)
    *points++ = pcl::isXYZFinite (p)
                    ? cv::Vec3f (p.x, p.y, p.z)
                    : cv::Vec3f::all (std::numeric_limits<float>::quiet_NaN());
  return image;
}

/** Brightness per point of a cloud of any shape, NaN = unknown; empty for types without
 * colour. */
template <typename PointT>
std::vector<float>
allBrightness (const pcl::PointCloud<PointT>& cloud)
{
  using namespace pcl::fields;
  std::vector<float> brightness;
  const auto gray = [] (const cv::Vec3b& bgr) {
    return (0.114F * bgr[0] + 0.587F * bgr[1] + 0.299F * bgr[2]) / 255.0F;
  };
  if constexpr (has_field<PointT, rgb>)
    for (const PointT& p : cloud)
      brightness.push_back (gray (packedColor<rgb> (p)));
  else if constexpr (has_field<PointT, rgba>)
    for (const PointT& p : cloud)
      brightness.push_back (gray (packedColor<rgba> (p)));
  else if constexpr (has_field<PointT, intensity>)
    for (const PointT& p : cloud)
      brightness.push_back (readIntensity (p));
  return brightness;
}

/** What nearest neighbours work on. */
struct NeighborTask {
  cv::Mat source;               ///< CV_32FC3, NaN = no point
  std::vector<cv::Mat> targets; ///< likewise, in the order of time
  int reference{0};             ///< targets that come before the source
  pcl::Indices points;          ///< of the source that take part
  std::vector<int> labels; ///< per source point, as CloudFlowEstimator takes segments
  CloudConstraints constraints;
  SolverParameters solver;
  MultiframeParameters multiframe;
  RigidPose start;
  std::vector<Eigen::Vector3f> normals;              ///< per source point, or empty
  std::vector<float> brightness;                     ///< per source point, or empty
  std::vector<std::vector<float>> target_brightness; ///< per target and point, or empty
  double brightness_weight{1.0};
};

/** Labels of a cloud of any shape, as labelImage tells them. */
PCL_MSF_EXPORT std::vector<int>
pointLabels (const pcl::PointCloud<pcl::Label>& labels);

PCL_MSF_EXPORT std::vector<Eigen::Vector3f>
pointNormals (const pcl::PointCloud<pcl::Normal>& normals);

/** Labels of a source of `size` points by clusters. A point in several belongs to the
 * first. \throws InvalidInput for indices outside */
PCL_MSF_EXPORT std::vector<int>
clusterLabels (const std::vector<pcl::PointIndices>& clusters, std::size_t size);

/** CloudFlows as the results of a window, each point a pixel of an image of the cloud's
 * width and height; parts, or given segments, are the segments. */
struct NeighborRegistration {
  MultiframeSceneFlow flow;
  std::vector<std::vector<CloudJoint>> joints; ///< per frame
  std::vector<int> target; ///< per source point, of the last target, -1 = none
};

/** No joints. */
PCL_MSF_EXPORT const std::vector<CloudJoint>&
noJoints ();

/** \throws InvalidInput naming the remedy */
PCL_MSF_EXPORT NeighborRegistration
registerByNeighbors (const NeighborTask& task);

} // namespace detail
} // namespace pcl_msf
