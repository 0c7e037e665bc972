// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgcodecs.hpp>

#include "io/datasets/file_lists.h"
#include "io/formats/decode_image.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/cloud_files.h>
#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/io/float_files.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/undistortion.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace pcl_msf::io {

namespace {

namespace fs = std::filesystem;

/** The first file `stem` + extension that exists, or nothing. */
std::string
firstOf (const std::string& stem, const std::vector<std::string>& extensions)
{
  for (const std::string& extension : extensions)
    if (fs::is_regular_file (stem + extension))
      return stem + extension;
  return {};
}

std::string
sizeText (const cv::Size& size)
{
  return std::to_string (size.width) + "x" + std::to_string (size.height);
}

void
checkSize (const std::string& path, const cv::Mat& image, const cv::Size& size)
{
  if (!image.empty() && image.size() != size)
    throw IoError (path + ": width, height: " + sizeText (image.size()) + " where " +
                   sizeText (size) +
                   " is expected; all images of a folder and its "
                   "camera.txt must agree");
}

void
replaceUnknown (cv::Mat& scene_flow)
{
  constexpr float kLargestKnown = 1e9F;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int row = 0; row < scene_flow.rows; ++row)
    for (int col = 0; col < scene_flow.cols; ++col) {
      auto& d = scene_flow.at<cv::Vec3f> (row, col);
      if (!(std::abs (d[0]) <= kLargestKnown && std::abs (d[1]) <= kLargestKnown &&
            std::abs (d[2]) <= kLargestKnown))
        d = {nan, nan, nan};
    }
}

} // namespace

DataFolder::DataFolder (const std::string& path) : path_ (path)
{
  if (!fs::is_directory (path))
    throw IoError (path + ": no such folder; check the path");
  while (!depthPath (frames_).empty() || !cloudPath (frames_).empty())
    ++frames_;
  if (frames_ == 0)
    throw IoError (path + ": frame 0: neither depth_0.png (.dpt, .pfm, .tiff) nor "
                          "cloud_0.pcd; give a folder in the project's layout");
  const std::string camera = (fs::path (path) / "camera.txt").string();
  if (fs::exists (camera) || !depthPath (0).empty())
    camera_ = readCamera (camera);
}

std::string
DataFolder::colorPath (int frame) const
{
  const auto stem = fs::path (path_) / ("color_" + std::to_string (frame));
  return firstOf (stem.string(), kColorExtensions);
}

std::string
DataFolder::depthPath (int frame) const
{
  const auto stem = fs::path (path_) / ("depth_" + std::to_string (frame));
  return firstOf (stem.string(), {".png", ".dpt", ".pfm", ".tiff", ".tif"});
}

std::string
DataFolder::cloudPath (int frame) const
{
  const auto stem = fs::path (path_) / ("cloud_" + std::to_string (frame));
  return firstOf (stem.string(), {".pcd"});
}

RgbdImages
DataFolder::frame (int frame, std::optional<double> depth_scale) const
{
  RgbdImages images = storedFrame (frame, depth_scale);
  if (camera_ && !depthPath (frame).empty())
    undistort (images, camera_->distortion);
  return images;
}

RgbdImages
DataFolder::storedFrame (int frame, std::optional<double> depth_scale) const
{
  const std::string depth = depthPath (frame);
  const std::string color = colorPath (frame);
  RgbdImages images;
  if (depth.empty()) {
    images = readCloudImages (cloudPath (frame),
                              camera_ ? std::optional (camera_->camera) : std::nullopt,
                              depth_scale.value_or (1.0));
  }
  else {
    images.camera = camera_->camera;
    images.depth = readDepth (
        depth, depth_scale.value_or (camera_->depth_scale), depth_scale.value_or (1.0));
    if (!color.empty())
      readColor (color, images);
  }
  const cv::Size size =
      camera_ ? cv::Size (camera_->width, camera_->height) : images.depth.size();
  checkSize (depth.empty() ? cloudPath (frame) : depth, images.depth, size);
  checkSize (color, images.color, size);
  return images;
}

std::string
DataFolder::truthPath (const std::string& name) const
{
  const fs::path path = fs::path (path_) / "gt" / name;
  return fs::is_regular_file (path) ? path.string() : std::string();
}

cv::Mat
DataFolder::flow (int frame) const
{
  const std::string path = truthPath ("flow_0_" + std::to_string (frame) + ".flo");
  return path.empty() ? cv::Mat() : readFlow (path);
}

cv::Mat
DataFolder::sceneFlow (int frame) const
{
  const std::string path =
      truthPath ("scene_flow_0_" + std::to_string (frame) + ".pfm");
  if (path.empty())
    return {};
  cv::Mat scene_flow = readPfm (path);
  if (scene_flow.type() != CV_32FC3)
    throw IoError (path + ": type: one channel (Pf), and a scene flow has three "
                          "(PF); give the file as it was written");
  replaceUnknown (scene_flow);
  return scene_flow;
}

cv::Mat
DataFolder::visible (int frame) const
{
  const std::string path = truthPath ("visible_0_" + std::to_string (frame) + ".png");
  return path.empty() ? cv::Mat() : readMask (path);
}

cv::Mat
DataFolder::labels (int frame) const
{
  const std::string path = truthPath ("labels_" + std::to_string (frame) + ".png");
  if (path.empty())
    return {};
  cv::Mat labels = readLabels (path);
  if (decodeImage (path, cv::IMREAD_UNCHANGED, "labels").depth() == CV_8U)
    labels.setTo (-1, labels == 255);
  return labels;
}

std::optional<RigidPose>
DataFolder::pose (int frame) const
{
  const std::string path = truthPath ("pose_" + std::to_string (frame) + ".txt");
  if (path.empty())
    return std::nullopt;
  return readPose (path);
}

} // namespace pcl_msf::io
