// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/cloud_colors.h"
#include "io/cloud_fields.h"
#include "io/pcd_blob.h"
#include "io/sensor_pose.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>

#include <cmath>
#include <string>

namespace pcl_msf::io {

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZRGBA>;

/** Positions alone. */
Cloud::Ptr
pointsOf (const pcl::PCLPointCloud2& blob, const CloudFields& fields)
{
  Cloud::Ptr cloud (new Cloud (blob.width, blob.height));
  cloud->is_dense = false;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    pcl::PointXYZRGBA& point = (*cloud)[i];
    fields.position (blob.data.data() + i * blob.point_step, point.x, point.y, point.z);
    point.rgba = 0;
  }
  return cloud;
}

} // namespace

Cloud::Ptr
readOrganizedCloud (const std::string& path)
{
  Viewpoint viewpoint;
  const pcl::PCLPointCloud2 blob = readPcd (path, &viewpoint);
  const CloudFields fields (blob, path);
  const Cloud::Ptr cloud = pointsOf (blob, fields);
  setViewpoint (viewpoint, *cloud);
  RgbdImages images;
  takeColors (blob, fields, images);
  for (int row = 0; row < images.color.rows; ++row)
    for (int col = 0; col < images.color.cols; ++col) {
      pcl::PointXYZRGBA& point = (*cloud) (col, row);
      const cv::Vec3b& bgr = images.color.at<cv::Vec3b> (row, col);
      point.b = bgr[0];
      point.g = bgr[1];
      point.r = bgr[2];
      point.a = 255;
    }
  return cloud;
}

RgbdImages
readCloudImages (const std::string& path,
                 const std::optional<PinholeCamera>& camera,
                 double units_per_metre)
{
  if (!std::isfinite (units_per_metre) || units_per_metre <= 0.0)
    throw InvalidInput ("units_per_metre: must be > 0, e.g. 1000 for millimetres");
  Viewpoint viewpoint;
  const pcl::PCLPointCloud2 blob = readPcd (path, &viewpoint);
  const CloudFields fields (blob, path);
  const Cloud::Ptr cloud = pointsOf (blob, fields);
  const cv::Mat points = coordinateImage (*cloud);
  RgbdImages images;
  std::string why;
  if (camera && !fitsCamera (points, *camera, &why))
    throw IoError (path + ": not the given camera's: " + why);
  if (camera)
    images.camera = *camera;
  else if (!estimateCamera (points, images.camera, &why))
    throw IoError (path + ": camera: " + why);
  images.depth = depthImage (pointImage (*cloud));
  if (units_per_metre != 1.0)
    images.depth /= units_per_metre;
  images.viewpoint = viewpoint;
  takeColors (blob, fields, images);
  return images;
}

} // namespace pcl_msf::io
