// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/PCLPointCloud2.h>

#include <opencv2/imgproc.hpp>

#include "io/cloud_fields.h"
#include "io/pcd_header.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>

#include <cstdint>
#include <exception>
#include <limits>
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

/** The points, NaN where z is not positive: as pointImage. */
cv::Mat
measuredPoints (const cv::Mat& points)
{
  cv::Mat measured = points.clone();
  for (int v = 0; v < points.rows; ++v)
    for (int u = 0; u < points.cols; ++u)
      if (auto& point = measured.at<cv::Vec3f> (v, u); !(point[2] > 0.0f))
        point = cv::Vec3f::all (std::numeric_limits<float>::quiet_NaN());
  return measured;
}

} // namespace

detail::CloudPixels
detail::readCloudPixels (const std::string& path)
{
  const pcl::PCLPointCloud2 blob = readBlob (path);
  const CloudFields fields (blob, path);
  const cv::Size size (static_cast<int> (blob.width), static_cast<int> (blob.height));
  CloudPixels pixels{cv::Mat (size, CV_32FC3), cv::Mat (size, CV_8UC4)};
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      const unsigned char* bytes =
          blob.data.data() + (std::size_t (v) * size.width + u) * blob.point_step;
      auto& point = pixels.points.at<cv::Vec3f> (v, u);
      fields.position (bytes, point[0], point[1], point[2]);
      const std::uint32_t color = fields.color (bytes);
      pixels.bgra.at<cv::Vec4b> (v, u) = {static_cast<unsigned char> (color),
                                          static_cast<unsigned char> (color >> 8U),
                                          static_cast<unsigned char> (color >> 16U),
                                          static_cast<unsigned char> (color >> 24U)};
    }
  return pixels;
}

RgbdImages
readCloudImages (const std::string& path, const std::optional<PinholeCamera>& camera)
{
  const detail::CloudPixels pixels = detail::readCloudPixels (path);
  const cv::Mat points = measuredPoints (pixels.points);
  RgbdImages images;
  std::string why;
  if (camera)
    images.camera = *camera;
  else if (!estimateCamera (points, images.camera, &why))
    throw IoError (path + ": camera: " + why + "; give the camera");
  images.depth = depthImage (points);
  if (pixels.bgra.at<cv::Vec4b> (0, 0)[3] != 0)
    cv::cvtColor (pixels.bgra, images.color, cv::COLOR_BGRA2BGR);
  return images;
}

} // namespace pcl_msf::io
