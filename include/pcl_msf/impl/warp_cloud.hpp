// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/common/point_tests.h>
#include <pcl/point_cloud.h>
#include <pcl/type_traits.h>

#include <pcl_msf/scene_flow.h>

#include <limits>
#include <numeric>
#include <vector>

namespace pcl_msf {
namespace detail {

/** Some of a cloud's points, n x 1, or organized when they are as many as the cloud's;
 * as pcl::Registration::align hands them to a method. */
template <typename PointT>
void
pickPoints (const pcl::PointCloud<PointT>& cloud,
            const pcl::Indices& indices,
            pcl::PointCloud<PointT>& output)
{
  const bool whole = indices.size() == cloud.size();
  output.resize (indices.size());
  output.width = whole ? cloud.width : static_cast<std::uint32_t> (indices.size());
  output.height = whole ? cloud.height : 1;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    output[i] = cloud[indices[i]];
    output[i].data[3] = 1.0f;
  }
}

/** Carries points to the current frame (Eq. 1); normals turn with their segments. A
 * point whose motion is unknown becomes NaN.
 * \param flow not empty
 * \param indices of the points in the reference, one per point of the cloud */
template <typename PointT>
void
warpCloud (const SceneFlow& flow,
           const pcl::Indices& indices,
           pcl::PointCloud<PointT>& cloud)
{
  std::vector<Eigen::Matrix3f> rotations;
  for (const SegmentMotion& segment : flow.segments)
    rotations.emplace_back (segment.current_from_reference.rotation().cast<float>());
  const int width = flow.displacement.cols;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const int v = indices[i] / width;
    const int u = indices[i] % width;
    const auto& d = flow.displacement.at<cv::Vec3f> (v, u);
    auto point = cloud[i].getVector3fMap();
    point += Eigen::Vector3f (d[0], d[1], d[2]);
    if (!pcl::isXYZFinite (cloud[i])) {
      point.setConstant (std::numeric_limits<float>::quiet_NaN());
      cloud.is_dense = false;
      continue;
    }
    if constexpr (pcl::traits::has_normal<PointT>::value) {
      const int label = flow.labels.at<int> (v, u);
      auto normal = cloud[i].getNormalVector3fMap();
      if (label >= 0)
        normal = (rotations[label] * normal).eval();
    }
  }
}

/** All points of the reference. */
template <typename PointT>
pcl::PointCloud<PointT>
warpedCloud (const SceneFlow& flow, const pcl::PointCloud<PointT>& reference)
{
  pcl::PointCloud<PointT> warped = reference;
  pcl::Indices all (warped.size());
  std::iota (all.begin(), all.end(), 0);
  warpCloud (flow, all, warped);
  return warped;
}

} // namespace detail
} // namespace pcl_msf
