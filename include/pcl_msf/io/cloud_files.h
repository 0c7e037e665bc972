// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <opencv2/core.hpp>

#include <pcl_msf/build_compatibility.h>
#include <pcl_msf/export.h>
#include <pcl_msf/io/rgbd_images.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::io {

namespace detail {
/** A cloud as images: memory that, unlike a pcl::PointCloud's, is the same for code
 * compiled with any flags. */
struct CloudPixels {
  cv::Mat points; ///< CV_32FC3, x y z as in the file
  cv::Mat bgra;   ///< CV_8UC4, as in PointXYZRGBA
  Viewpoint viewpoint{};
};

PCL_MSF_EXPORT CloudPixels
readCloudPixels (const std::string& path);

/** Several, whose colours have one unit. */
PCL_MSF_EXPORT std::vector<CloudPixels>
readCloudPixels (const std::vector<std::string>& paths);

inline pcl::PointCloud<pcl::PointXYZRGBA>::Ptr
cloudOf (const CloudPixels& pixels)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGBA>> (
      pixels.points.cols, pixels.points.rows);
  cloud->is_dense = false;
  const auto& t = pixels.viewpoint.origin;
  const auto& q = pixels.viewpoint.orientation;
  cloud->sensor_origin_ = Eigen::Vector4f (t[0], t[1], t[2], 0.0F);
  cloud->sensor_orientation_ = Eigen::Quaternionf (q[0], q[1], q[2], q[3]);
  for (int v = 0; v < pixels.points.rows; ++v)
    for (int u = 0; u < pixels.points.cols; ++u) {
      const auto& position = pixels.points.at<cv::Vec3f> (v, u);
      const auto& color = pixels.bgra.at<cv::Vec4b> (v, u);
      auto& point = (*cloud) (u, v);
      point.getVector3fMap() = Eigen::Vector3f (position[0], position[1], position[2]);
      point.b = color[0];
      point.g = color[1];
      point.r = color[2];
      point.a = color[3];
    }
  return cloud;
}
} // namespace detail

/** \brief Reads an organized cloud from a .pcd file (ascii, binary or compressed).
 *
 * Fields x y z are required (camera frame, NaN = no point). Colour is, in this order:
 * rgb or rgba as PCL packs them or of three numbers; r g b; red green blue; intensity
 * (or intensities, gray, grey). Bytes are 0 .. 255; other numbers are brought to that
 * range by normalizeIntensity, from the values of this cloud: read clouds of one scene
 * by readOrganizedClouds. Other fields are ignored.
 * With colour every point's alpha is 255, without any it is 0.
 * \throws IoError for anything else, unorganized clouds included */
inline pcl::PointCloud<pcl::PointXYZRGBA>::Ptr
readOrganizedCloud (const std::string& path)
{
  return detail::cloudOf (detail::readCloudPixels (path));
}

/** \brief Reads clouds that are to be registered: as readOrganizedCloud, but colours
 * that are no bytes are brought to that range from the values of all of them, so that
 * what is equally bright stays so. \throws IoError, also as readOrganizedCloud, and
 * InvalidInput when they have two units (shares of 1, 0 to 255) */
inline std::vector<pcl::PointCloud<pcl::PointXYZRGBA>::Ptr>
readOrganizedClouds (const std::vector<std::string>& paths)
{
  std::vector<pcl::PointCloud<pcl::PointXYZRGBA>::Ptr> clouds;
  for (const detail::CloudPixels& pixels : detail::readCloudPixels (paths))
    clouds.push_back (detail::cloudOf (pixels));
  return clouds;
}

/** \brief Reads an organized cloud as images, see readOrganizedCloud; `note` says when
 * there is no colour.
 *
 * \param camera of the cloud's sensor; when not given it is taken from the points
 * (estimateCamera) \param units_per_metre of x y z, > 0, e.g. 1000 for millimetres
 * \throws IoError, also when the points tell no camera or are not an image of the given
 * one (fitsCamera) */
PCL_MSF_EXPORT RgbdImages
readCloudImages (const std::string& path,
                 const std::optional<PinholeCamera>& camera = {},
                 double units_per_metre = 1.0);

} // namespace pcl_msf::io
