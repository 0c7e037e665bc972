// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/PCLPointCloud2.h>

#include "io/cloud_colors.h"
#include "io/cloud_fields.h"
#include "io/pcd_blob.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/point_types.h>

#include <algorithm>
#include <array>
#include <limits>

namespace pcl_msf::io {

namespace {

constexpr std::uint32_t kMostSegments = 1U << 24U; ///< more is no label but damage

void
requireFields (const pcl::PCLPointCloud2& blob, const std::string& path)
{
  using Field = pcl::PCLPointField;
  const std::array<std::pair<const char*, int>, 8> wanted{{{"x", Field::FLOAT32},
                                                           {"y", Field::FLOAT32},
                                                           {"z", Field::FLOAT32},
                                                           {"dx", Field::FLOAT32},
                                                           {"dy", Field::FLOAT32},
                                                           {"dz", Field::FLOAT32},
                                                           {"label", Field::UINT32},
                                                           {"visible", Field::UINT8}}};
  for (const auto& [name, type] : wanted) {
    const auto field =
        std::find_if (blob.fields.begin(),
                      blob.fields.end(),
                      [name = name] (const Field& f) { return f.name == name; });
    if (field == blob.fields.end() || field->datatype != type)
      throw IoError (path + ": " + name +
                     ": the field is missing or of another type; "
                     "give a scene_flow .pcd");
  }
  if (blob.height < 2 || blob.width < 2)
    throw IoError (path + ": WIDTH, HEIGHT: " + std::to_string (blob.width) + " x " +
                   std::to_string (blob.height) +
                   " is no image; give a scene_flow .pcd");
}

pcl::PointCloud<PointXYZRGBFlow>
pointsOf (const pcl::PCLPointCloud2& blob)
{
  pcl::PointCloud<PointXYZRGBFlow> cloud;
  const pcl::console::VERBOSITY_LEVEL before = pcl::console::getVerbosityLevel();
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); // it warns about colours
  pcl::fromPCLPointCloud2 (blob, cloud);
  pcl::console::setVerbosityLevel (before);
  return cloud;
}

unsigned char
visibilityOf (const PointXYZRGBFlow& point)
{
  if (!(point.z > 0.0F))
    return Visibility::NoDepth;
  return point.visible != 0 ? Visibility::Visible : Visibility::Unknown;
}

void
takePoints (const pcl::PointCloud<PointXYZRGBFlow>& cloud,
            const std::string& path,
            StoredSceneFlow& stored)
{
  SceneFlow& flow = stored.scene_flow;
  const cv::Size size (static_cast<int> (cloud.width), static_cast<int> (cloud.height));
  flow.points = pointImage (cloud);
  flow.labels.create (size, CV_32SC1);
  flow.displacement.create (size, CV_32FC3);
  flow.visibility.create (size, CV_8UC1);
  for (int row = 0; row < size.height; ++row)
    for (int col = 0; col < size.width; ++col) {
      const PointXYZRGBFlow& point = cloud (col, row);
      if (point.label != PointXYZRGBFlow::kNoLabel && point.label >= kMostSegments)
        throw IoError (path + ": label: " + std::to_string (point.label) +
                       " is no segment's number; give a scene_flow .pcd of "
                       "pcl_msf_scene_flow");
      const bool none = point.label == PointXYZRGBFlow::kNoLabel;
      flow.labels.at<int> (row, col) = none ? -1 : static_cast<int> (point.label);
      flow.displacement.at<cv::Vec3f> (row, col) = {point.dx, point.dy, point.dz};
      flow.visibility.at<unsigned char> (row, col) = visibilityOf (point);
    }
}

/** Empty when the file was written without an image, all white. PCL's own conversion
 * drops colours that the file holds as integers. */
cv::Mat
colorOf (const pcl::PCLPointCloud2& blob, const std::string& path)
{
  RgbdImages images;
  takeColors (blob, CloudFields (blob, path), images);
  const bool known = cv::countNonZero (images.color.reshape (1) != 255) > 0;
  return known ? images.color : cv::Mat();
}

void
projectFlow (SceneFlow& flow)
{
  flow.flow.create (flow.points.size(), CV_32FC2);
  for (int row = 0; row < flow.points.rows; ++row)
    for (int col = 0; col < flow.points.cols; ++col) {
      const cv::Vec3f p = flow.points.at<cv::Vec3f> (row, col) +
                          flow.displacement.at<cv::Vec3f> (row, col);
      auto& f = flow.flow.at<cv::Vec2f> (row, col);
      f = cv::Vec2f::all (std::numeric_limits<float>::quiet_NaN());
      if (!(p[2] > 0.0F))
        continue;
      const Eigen::Vector2d pixel = flow.camera.project ({p[0], p[1], p[2]});
      f = {static_cast<float> (pixel.x() - col), static_cast<float> (pixel.y() - row)};
    }
}

void
countSegments (SceneFlow& flow)
{
  for (int row = 0; row < flow.labels.rows; ++row)
    for (int col = 0; col < flow.labels.cols; ++col) {
      const int label = flow.labels.at<int> (row, col);
      if (label < 0)
        continue;
      if (label >= static_cast<int> (flow.segments.size()))
        flow.segments.resize (label + 1);
      SegmentMotion& segment = flow.segments[label];
      ++segment.points;
      if (flow.visibility.at<unsigned char> (row, col) == Visibility::Visible)
        ++segment.visible_points;
      if (flow.displacement.at<cv::Vec3f> (row, col)[2] < 1e9F)
        segment.status = MotionStatus::Determined;
    }
}

} // namespace

StoredSceneFlow
readSceneFlowCloud (const std::string& path)
{
  StoredSceneFlow stored;
  const pcl::PCLPointCloud2 blob = readPcd (path, &stored.viewpoint);
  requireFields (blob, path);
  takePoints (pointsOf (blob), path, stored);
  stored.color = colorOf (blob, path);
  SceneFlow& flow = stored.scene_flow;
  std::string why;
  if (!estimateCamera (flow.points, flow.camera, &why))
    throw IoError (path + ": camera: " + why +
                   "; give a scene_flow .pcd of pcl_msf_scene_flow");
  projectFlow (flow);
  countSegments (flow);
  return stored;
}

} // namespace pcl_msf::io
