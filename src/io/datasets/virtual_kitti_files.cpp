// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/virtual_kitti_files.h"

#include "io/datasets/frame_parts.h"
#include <pcl_msf/io/images.h>

#include <cstdint>
#include <filesystem>
#include <limits>

namespace pcl_msf::io {

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr std::uint16_t kLargest = 65535;

/** A 16-bit value mapped to [-1, 1]. */
double
symmetric (std::uint16_t value)
{
  return 2.0 * value / kLargest - 1.0;
}

bool
endsWith (const std::string& text, const std::string& end)
{
  return text.size() >= end.size() &&
         text.compare (text.size() - end.size(), end.size(), end) == 0;
}

} // namespace

cv::Mat
readVirtualKittiDepth (const std::string& path)
{
  return readDepth (path, 100.0);
}

cv::Mat
readVirtualKittiFlow (const std::string& path)
{
  const cv::Mat image = readDeepColor (path, "flow");
  cv::Mat flow (image.size(), CV_32FC2, cv::Scalar (kNan, kNan));
  for (int row = 0; row < image.rows; ++row)
    for (int col = 0; col < image.cols; ++col) {
      const auto bgr = image.at<cv::Vec3w> (row, col);
      if (bgr[0] != 0)
        flow.at<cv::Vec2f> (row, col) = {
            static_cast<float> (symmetric (bgr[2]) * (image.cols - 1)),
            static_cast<float> (symmetric (bgr[1]) * (image.rows - 1))};
    }
  return flow;
}

cv::Mat
readVirtualKittiSceneFlow (const std::string& path)
{
  constexpr double kRange = 10.0;
  const auto isCut = [] (std::uint16_t value) {
    return value == 0 || value == kLargest;
  };
  const cv::Mat image = readDeepColor (path, "scene flow");
  cv::Mat scene_flow (image.size(), CV_32FC3, cv::Scalar (kNan, kNan, kNan));
  for (int row = 0; row < image.rows; ++row)
    for (int col = 0; col < image.cols; ++col) {
      const auto bgr = image.at<cv::Vec3w> (row, col);
      if (!isCut (bgr[0]) && !isCut (bgr[1]) && !isCut (bgr[2]))
        scene_flow.at<cv::Vec3f> (row, col) = {
            static_cast<float> (symmetric (bgr[2]) * kRange),
            static_cast<float> (symmetric (bgr[1]) * kRange),
            static_cast<float> (symmetric (bgr[0]) * kRange)};
    }
  return scene_flow;
}

std::string
inOtherArchive (const std::string& path,
                const std::string& part,
                const std::string& other)
{
  std::filesystem::path changed;
  bool found = false;
  for (const auto& element : std::filesystem::path (path)) {
    std::string name = element.string();
    if (name.rfind ("vkitti_", 0) == 0 && endsWith (name, "_" + part)) {
      name.replace (name.size() - part.size(), part.size(), other);
      found = true;
    }
    changed /= name;
  }
  return found ? changed.string() : std::string();
}

} // namespace pcl_msf::io
