// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/flying_things_files.h"

#include "io/datasets/file_lists.h"
#include "io/datasets/text_table.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/float_files.h>

#include <cmath>
#include <filesystem>
#include <limits>

namespace pcl_msf::io {

namespace {

const char*
direction (bool future)
{
  return future ? "/into_future/" : "/into_past/";
}

cv::Mat
readOneChannel (const std::string& path, const std::string& field)
{
  cv::Mat image = readPfm (path);
  if (image.type() != CV_32FC1)
    throw IoError (
        path + ": " + field +
        ": three channels (PF), not one (Pf); give the file of the data set");
  return image;
}

} // namespace

std::string
FlyingThingsPlace::disparity (const std::string& frame) const
{
  return inside (top, "disparity/" + sequence + "/" + view + "/" + frame + ".pfm");
}

std::string
FlyingThingsPlace::disparityChange (const std::string& frame, bool future) const
{
  return inside (top,
                 "disparity_change/" + sequence + direction (future) + view + "/" +
                     frame + ".pfm");
}

std::string
FlyingThingsPlace::flow (const std::string& frame, bool future) const
{
  const std::string stem = future ? "OpticalFlowIntoFuture_" : "OpticalFlowIntoPast_";
  return inside (top,
                 "optical_flow/" + sequence + direction (future) + view + "/" + stem +
                     frame + (view == "left" ? "_L" : "_R") + ".pfm");
}

std::string
FlyingThingsPlace::cameraData() const
{
  return inside (top, "camera_data/" + sequence + "/camera_data.txt");
}

std::optional<FlyingThingsPlace>
findFlyingThings (const std::string& folder, const std::string& pass)
{
  namespace fs = std::filesystem;
  const std::string lossless = "frames_" + pass + "pass";
  fs::path above = fs::path (folder).parent_path();
  for (; above.has_relative_path(); above = above.parent_path()) {
    const std::string name = above.filename().string();
    if (name != lossless && name != lossless + "_webp")
      continue;
    const std::string top = above.parent_path().string();
    const fs::path sequence =
        fs::path (folder).parent_path().lexically_relative (above);
    const fs::path better = fs::path (top) / lossless / sequence;
    if (sequence == "." || (name != lossless && isFolder (better.string())))
      return std::nullopt;
    return FlyingThingsPlace{top, sequence.generic_string(), lastName (folder)};
  }
  return std::nullopt;
}

cv::Mat
readDisparity (const std::string& path)
{
  return readOneChannel (path, "disparity");
}

cv::Mat
readDisparityChange (const std::string& path)
{
  return readOneChannel (path, "disparity change");
}

cv::Mat
readFlyingThingsFlow (const std::string& path)
{
  const cv::Mat image = readPfm (path);
  if (image.type() != CV_32FC3)
    throw IoError (path +
                   ": flow: one channel (Pf), not three (PF); give the file of the "
                   "data set");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cv::Mat flow (image.size(), CV_32FC2, cv::Scalar (nan, nan));
  for (int row = 0; row < image.rows; ++row)
    for (int col = 0; col < image.cols; ++col) {
      const auto f = image.at<cv::Vec3f> (row, col);
      if (std::isfinite (f[0]) && std::isfinite (f[1]))
        flow.at<cv::Vec2f> (row, col) = {f[0], f[1]};
    }
  return flow;
}

cv::Mat
laterDisparity (const cv::Mat& disparity, const cv::Mat& change)
{
  cv::Mat later (disparity.size(), CV_32FC1);
  for (int row = 0; row < later.rows; ++row)
    for (int col = 0; col < later.cols; ++col) {
      const float before = disparity.at<float> (row, col);
      const float after = before + change.at<float> (row, col);
      later.at<float> (row, col) = before * after > 0.0F
                                       ? std::abs (after)
                                       : std::numeric_limits<float>::quiet_NaN();
    }
  return later;
}

std::map<int, RigidPose>
readCameraData (const std::string& path, char view)
{
  // Half a turn about x: from x right, y down, z forward to x right, y up, z backwards.
  const RigidPose from_optical = RigidPose::fromMatrix (
      Eigen::Vector3d (1.0, -1.0, -1.0).asDiagonal().toDenseMatrix(),
      Eigen::Vector3d::Zero());
  const TextTable table (path);
  std::map<int, RigidPose> poses;
  int frame = -1;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& word = table.word (row, 0, "Frame, L or R");
    if (word == "Frame")
      frame = table.wholeNumber (row, 1, "frame");
    else if (word != "L" && word != "R")
      table.fail (row,
                  "Frame, L or R",
                  "the line begins with '" + word.substr (0, 32) +
                      "'; give the file of the data set");
    else if (word[0] == view)
      poses[frame] = table.pose (row, 1) * from_optical;
  }
  return poses;
}

} // namespace pcl_msf::io
