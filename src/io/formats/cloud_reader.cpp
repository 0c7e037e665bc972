// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "io/formats/cloud_colors.h"
#include "io/formats/cloud_fields.h"
#include "io/formats/pcd_blob.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace pcl_msf::io {

namespace {

const cv::Vec3f kNoPoint = cv::Vec3f::all (std::numeric_limits<float>::quiet_NaN());

/** Coordinates as they are in the file, CV_32FC3. */
cv::Mat
coordinatesOf (const pcl::PCLPointCloud2& blob, const CloudFields& fields)
{
  cv::Mat points (
      static_cast<int> (blob.height), static_cast<int> (blob.width), CV_32FC3);
  const unsigned char* bytes = blob.data.data();
  for (int v = 0; v < points.rows; ++v)
    for (int u = 0; u < points.cols; ++u, bytes += blob.point_step) {
      auto& point = points.at<cv::Vec3f> (v, u);
      fields.position (bytes, point[0], point[1], point[2]);
    }
  return points;
}

/** NaN where a coordinate is not a number or, when `ahead`, z is not positive. */
cv::Mat
finitePoints (const cv::Mat& points, bool ahead)
{
  cv::Mat result = points.clone();
  for (int v = 0; v < points.rows; ++v)
    for (int u = 0; u < points.cols; ++u) {
      auto& p = result.at<cv::Vec3f> (v, u);
      const bool finite =
          std::isfinite (p[0]) && std::isfinite (p[1]) && std::isfinite (p[2]);
      if (!finite || (ahead && !(p[2] > 0.0F)))
        p = kNoPoint;
    }
  return result;
}

} // namespace

detail::CloudPixels
detail::readCloudPixels (const std::string& path)
{
  return readCloudPixels (std::vector<std::string>{path}).front();
}

std::vector<detail::CloudPixels>
detail::readCloudPixels (const std::vector<std::string>& paths)
{
  std::vector<CloudPixels> clouds (paths.size());
  std::vector<RgbdImages> images (paths.size());
  std::vector<RgbdImages*> all;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const pcl::PCLPointCloud2 blob = readPcd (paths[i], &clouds[i].viewpoint);
    const CloudFields fields (blob, paths[i]);
    clouds[i].points = coordinatesOf (blob, fields);
    takeColors (blob, fields, images[i]);
    all.push_back (&images[i]);
  }
  unifyColors (all);
  for (std::size_t i = 0; i < paths.size(); ++i)
    if (images[i].color.empty())
      clouds[i].bgra = cv::Mat (clouds[i].points.size(), CV_8UC4, cv::Scalar::all (0));
    else
      cv::cvtColor (images[i].color, clouds[i].bgra, cv::COLOR_BGR2BGRA);
  return clouds;
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
  const cv::Mat points = finitePoints (coordinatesOf (blob, fields), false);
  RgbdImages images;
  std::string why;
  if (camera && !fitsCamera (points, *camera, &why))
    throw IoError (path + ": not the given camera's: " + why);
  if (camera)
    images.camera = *camera;
  else if (!estimateCamera (points, images.camera, &why))
    throw IoError (path + ": camera: " + why);
  images.depth = depthImage (finitePoints (points, true));
  if (units_per_metre != 1.0)
    images.depth /= units_per_metre;
  images.viewpoint = viewpoint;
  takeColors (blob, fields, images);
  return images;
}

} // namespace pcl_msf::io
