// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/PCLPointCloud2.h>

#include "io/cloud_fields.h"
#include "io/pcd_header.h"
#include "io/sensor_pose.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>

#include <exception>
#include <string>

namespace pcl_msf::io {

namespace {

pcl::PCLPointCloud2
readBlob (const std::string& path,
          Eigen::Vector4f& sensor_origin,
          Eigen::Quaternionf& sensor_orientation)
{
  checkPcdHeader (path);
  pcl::PCLPointCloud2 blob;
  int status = -1;
  try {
    pcl::PCDReader reader;
    int version = 0;
    status = reader.read (path, blob, sensor_origin, sensor_orientation, version);
  }
  catch (const std::exception&) {
    status = -1;
  }
  const bool whole =
      blob.data.size() == std::size_t{blob.width} * blob.height * blob.point_step;
  if (status < 0 || !whole)
    throw IoError (path + ": points: PCL cannot read them; the file is damaged");
  return blob;
}

} // namespace

pcl::PointCloud<pcl::PointXYZRGBA>::Ptr
readOrganizedCloud (const std::string& path)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGBA>>();
  const pcl::PCLPointCloud2 blob =
      readBlob (path, cloud->sensor_origin_, cloud->sensor_orientation_);
  const CloudFields fields (blob, path);
  cloud->resize (blob.width, blob.height);
  cloud->is_dense = false;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const unsigned char* bytes = blob.data.data() + i * blob.point_step;
    pcl::PointXYZRGBA& point = (*cloud)[i];
    fields.position (bytes, point.x, point.y, point.z);
    point.rgba = fields.color (bytes);
  }
  return cloud;
}

RgbdImages
readCloudImages (const std::string& path, const std::optional<PinholeCamera>& camera)
{
  const auto cloud = readOrganizedCloud (path);
  const cv::Mat points = pointImage (*cloud);
  RgbdImages images;
  std::string why;
  if (camera)
    images.camera = *camera;
  else if (!estimateCamera (points, images.camera, &why))
    throw IoError (path + ": camera: " + why + "; give the camera");
  images.depth = depthImage (points);
  if (cloud->front().a != 0)
    images.color = colorImage (*cloud);
  images.viewpoint = viewpointOf (*cloud);
  return images;
}

} // namespace pcl_msf::io
