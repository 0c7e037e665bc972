// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/cloud_images.h"

#include <pcl_msf/errors.h>

#include <string>

namespace pcl_msf::tool {

PinholeCamera
CloudImages::cameraOf (const cv::Mat& coordinates)
{
  std::string why;
  if (camera_ && !fitsCamera (coordinates, *camera_, &why))
    throw InvalidInput ("cloud: not the camera's: " + why);
  if (!camera_ && !estimateCamera (coordinates, camera_.emplace(), &why)) {
    camera_.reset();
    throw InvalidInput ("cloud: camera: " + why);
  }
  return *camera_;
}

void
CloudImages::takeColor (const cv::Mat& color, io::RgbdImages& images)
{
  if (color.empty())
    images.note = "the clouds have no colour: geometry alone";
  else if (color.depth() == CV_32F)
    images.raw_color = color; // the stream's unit is chosen by its first frame
  else
    images.color = color;
}

} // namespace pcl_msf::tool
