// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/frame_parts.h"

#include <opencv2/imgcodecs.hpp>

#include "io/datasets/file_lists.h"
#include "io/formats/decode_image.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/io/text_files.h>
#include <pcl_msf/io/undistortion.h>

#include <cmath>
#include <limits>

namespace pcl_msf::io {

namespace {

std::string
sizeText (const cv::Size& size)
{
  return std::to_string (size.width) + "x" + std::to_string (size.height);
}

} // namespace

std::string
noSuchFrame (const std::string& sequence, int frame, int frames)
{
  return sequence + ": frame " + std::to_string (frame) + ": there are " +
         std::to_string (frames) + " frames, from 0 on; choose one of them";
}

void
requireSize (const std::string& path, const cv::Mat& image, const cv::Size& size)
{
  if (!size.empty() && image.size() != size)
    throw IoError (path + ": width, height: " + sizeText (image.size()) + " where " +
                   sizeText (size) +
                   " is expected; give the images as they were published, or the "
                   "camera of scaled ones");
}

RgbdImages
makeFrame (const std::string& color_path,
           const std::string& depth_path,
           const cv::Mat& depth,
           const PinholeCamera& camera,
           const LensDistortion& distortion)
{
  RgbdImages images;
  images.depth = depth;
  images.camera = camera;
  std::string why;
  if (!camera.isValid (depth.cols, depth.rows, &why))
    throw IoError (depth_path + ": camera: " + why);
  if (!color_path.empty()) {
    readColor (color_path, images);
    requireSize (color_path, images.color, depth.size());
  }
  undistort (images, distortion);
  return images;
}

cv::Mat
readDeepColor (const std::string& path, const std::string& field)
{
  cv::Mat image = decodeImage (path, cv::IMREAD_UNCHANGED, field);
  if (image.type() != CV_16UC3)
    throw IoError (path + ": " + field +
                   ": not 16 bit in three channels; the file is of another format");
  return image;
}

cv::Mat
depthFromDisparity (const cv::Mat& disparity,
                    double focal_times_baseline,
                    double offset)
{
  cv::Mat depth (
      disparity.size(), CV_32FC1, cv::Scalar (std::numeric_limits<float>::quiet_NaN()));
  for (int row = 0; row < disparity.rows; ++row)
    for (int col = 0; col < disparity.cols; ++col) {
      const float d = disparity.at<float> (row, col);
      if (std::isfinite (d) && d > 0.0F && d + offset > 0.0)
        depth.at<float> (row, col) =
            static_cast<float> (focal_times_baseline / (d + offset));
    }
  return depth;
}

CameraChoice
chooseCamera (const std::string& folder,
              const DatasetOptions& options,
              const CameraChoice& known)
{
  CameraChoice choice = known;
  const std::string path = inside (folder, "camera.txt");
  if (isFile (path)) {
    const CameraFile file = readCamera (path);
    choice.camera = file.camera;
    choice.distortion = file.distortion;
    choice.depth_scale = file.depth_scale;
    choice.size = {file.width, file.height};
  }
  if (options.camera) {
    choice.camera = *options.camera;
    choice.distortion = {};
    choice.size = {};
  }
  choice.distortion = options.distortion.value_or (choice.distortion);
  choice.depth_scale = options.depth_scale.value_or (choice.depth_scale);
  choice.float_scale = options.depth_scale.value_or (1.0);
  return choice;
}

} // namespace pcl_msf::io
