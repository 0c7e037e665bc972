// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/cloud_conversions.h>

#include <cstdint>
#include <limits>

namespace pcl_msf {

cv::Mat
depthImage (const cv::Mat& points)
{
  cv::Mat depth;
  cv::extractChannel (points, depth, 2);
  return depth;
}

cv::Mat
normalImage (const pcl::PointCloud<pcl::Normal>& normals)
{
  requireOrganized (normals, "normal cloud");
  return detail::mapPoints<cv::Vec3f> (normals, [] (const pcl::Normal& n) {
    return cv::Vec3f (n.normal_x, n.normal_y, n.normal_z);
  });
}

cv::Mat
labelImage (const pcl::PointCloud<pcl::Label>& labels)
{
  requireOrganized (labels, "label cloud");
  return detail::mapPoints<int> (labels, [] (const pcl::Label& l) {
    constexpr std::uint32_t largest = std::numeric_limits<int>::max();
    return l.label <= largest ? static_cast<int> (l.label) : -1;
  });
}

} // namespace pcl_msf
