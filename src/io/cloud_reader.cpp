// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/PCLPointCloud2.h>

#include "io/cloud_fields.h"
#include "io/pcd_header.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>

#include <exception>
#include <string>

namespace pcl_msf::io {

namespace {

pcl::PCLPointCloud2
readBlob (const std::string& path)
{
  checkPcdHeader (path);
  pcl::PCLPointCloud2 blob;
  int status = -1;
  try {
    pcl::PCDReader reader;
    status = reader.read (path, blob);
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
  const pcl::PCLPointCloud2 blob = readBlob (path);
  const CloudFields fields (blob, path);
  pcl::PointCloud<pcl::PointXYZRGBA>::Ptr cloud (
      new pcl::PointCloud<pcl::PointXYZRGBA> (blob.width, blob.height));
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
  if (cloud->front().a != 0)
    images.color = colorImage (*cloud);
  return images;
}

} // namespace pcl_msf::io
