// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/PCLPointCloud2.h>

#include "io/formats/cloud_colors.h"
#include "io/formats/cloud_fields.h"
#include "io/formats/pcd_blob.h"
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/point_types.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl_msf::io {

namespace {

constexpr std::uint32_t kMostSegments = 1U << 24U; ///< more is no label but damage

/** Where a scene_flow file's points hold what. */
struct FlowFields {
  FlowFields (const pcl::PCLPointCloud2& blob, const std::string& path);

  std::uint32_t position[3], displacement[3], label, visible;
  std::uint32_t flow_deviation{0}, displacement_deviation{0}; ///< 0 = not in the file
};

std::uint32_t
offsetOf (const pcl::PCLPointCloud2& blob,
          const std::string& name,
          int type,
          const std::string& path)
{
  for (const pcl::PCLPointField& field : blob.fields)
    if (field.name == name && field.datatype == type)
      return field.offset;
  throw IoError (path + ": " + name +
                 ": the field is missing or of another type; give a scene_flow .pcd");
}

FlowFields::FlowFields (const pcl::PCLPointCloud2& blob, const std::string& path)
{
  const std::string axes[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i)
    position[i] = offsetOf (blob, axes[i], pcl::PCLPointField::FLOAT32, path);
  for (int i = 0; i < 3; ++i)
    displacement[i] = offsetOf (blob, "d" + axes[i], pcl::PCLPointField::FLOAT32, path);
  label = offsetOf (blob, "label", pcl::PCLPointField::UINT32, path);
  visible = offsetOf (blob, "visible", pcl::PCLPointField::UINT8, path);
  for (const pcl::PCLPointField& field : blob.fields) {
    if (field.datatype != pcl::PCLPointField::FLOAT32)
      continue;
    if (field.name == "flow_deviation")
      flow_deviation = field.offset;
    if (field.name == "displacement_deviation")
      displacement_deviation = field.offset;
  }
}

template <typename T>
T
valueAt (const unsigned char* bytes)
{
  T value;
  std::memcpy (&value, bytes, sizeof (T));
  return value;
}

cv::Vec3f
vectorAt (const unsigned char* point, const std::uint32_t (&offsets)[3])
{
  return {valueAt<float> (point + offsets[0]),
          valueAt<float> (point + offsets[1]),
          valueAt<float> (point + offsets[2])};
}

/** Segment number, -1 = none. */
int
labelOf (std::uint32_t label, const std::string& path)
{
  if (label == PointXYZRGBFlow::kNoLabel)
    return -1;
  if (label >= kMostSegments)
    throw IoError (
        path + ": label: " + std::to_string (label) +
        " is no segment's number; give a scene_flow .pcd of pcl_msf_scene_flow");
  return static_cast<int> (label);
}

Visibility
visibilityOf (const cv::Vec3f& position, unsigned char visible)
{
  if (!(position[2] > 0.0F))
    return Visibility::NoDepth;
  return visible != 0 ? Visibility::Visible : Visibility::Unknown;
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

/** A field of the points as an image; empty for a field that the file does not have. */
cv::Mat
imageOf (const pcl::PCLPointCloud2& blob, std::uint32_t offset)
{
  if (offset == 0)
    return {};
  cv::Mat image (
      static_cast<int> (blob.height), static_cast<int> (blob.width), CV_32FC1);
  for (std::size_t i = 0; i < image.total(); ++i)
    image.ptr<float>()[i] =
        valueAt<float> (blob.data.data() + i * blob.point_step + offset);
  return image;
}

StoredSceneFlow
readPoints (const std::string& path)
{
  StoredSceneFlow stored;
  const pcl::PCLPointCloud2 blob = readPcd (path, &stored.viewpoint);
  const FlowFields fields (blob, path);
  if (blob.height < 2 || blob.width < 2)
    throw IoError (path + ": WIDTH, HEIGHT: " + std::to_string (blob.width) + " x " +
                   std::to_string (blob.height) +
                   " is no image; give a scene_flow .pcd");
  const cv::Size size (static_cast<int> (blob.width), static_cast<int> (blob.height));
  stored.color = colorOf (blob, path);
  SceneFlow& flow = stored.scene_flow;
  flow.points.create (size, CV_32FC3);
  flow.labels.create (size, CV_32SC1);
  flow.displacement.create (size, CV_32FC3);
  flow.visibility.create (size, CV_8UC1);
  for (int i = 0; i < size.area(); ++i) {
    const unsigned char* point = blob.data.data() + std::size_t (i) * blob.point_step;
    const cv::Point at (i % size.width, i / size.width);
    const cv::Vec3f position = vectorAt (point, fields.position);
    const bool measured = std::isfinite (position[0]) && std::isfinite (position[1]) &&
                          std::isfinite (position[2]) && position[2] > 0.0F;
    flow.points.at<cv::Vec3f> (at) =
        measured ? position : cv::Vec3f::all (std::numeric_limits<float>::quiet_NaN());
    flow.displacement.at<cv::Vec3f> (at) = vectorAt (point, fields.displacement);
    flow.labels.at<int> (at) =
        labelOf (valueAt<std::uint32_t> (point + fields.label), path);
    flow.visibility.at<unsigned char> (at) =
        pixelValue (visibilityOf (position, point[fields.visible]));
  }
  flow.flow_deviation = imageOf (blob, fields.flow_deviation);
  flow.displacement_deviation = imageOf (blob, fields.displacement_deviation);
  return stored;
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
  StoredSceneFlow stored = readPoints (path);
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
