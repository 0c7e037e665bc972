// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/video/tracking.hpp>

#include "io/formats/tagged_floats.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/float_files.h>

#include <cmath>
#include <limits>

namespace pcl_msf::io {

namespace {

constexpr float kLargestKnown = 1e9F;
constexpr float kUnknown = 1e10F;

bool
isKnown (const cv::Vec2f& flow)
{
  return std::abs (flow[0]) <= kLargestKnown && std::abs (flow[1]) <= kLargestKnown;
}

void
replaceUnknown (cv::Mat& flow, float value)
{
  for (int row = 0; row < flow.rows; ++row) {
    auto* pixels = flow.ptr<cv::Vec2f> (row);
    for (int col = 0; col < flow.cols; ++col)
      if (!isKnown (pixels[col]))
        pixels[col] = {value, value};
  }
}

} // namespace

cv::Mat
readFlow (const std::string& path)
{
  checkTaggedFloats (path, 2);
  cv::Mat flow = cv::readOpticalFlow (path);
  if (flow.empty())
    throw IoError (path + ": OpenCV cannot read it");
  replaceUnknown (flow, std::numeric_limits<float>::quiet_NaN());
  return flow;
}

void
writeFlow (const std::string& path, const cv::Mat& flow)
{
  if (flow.type() != CV_32FC2 || flow.empty())
    throw IoError (path + ": flow: a CV_32FC2 image is needed");
  cv::Mat known = flow.clone();
  replaceUnknown (known, kUnknown);
  writeTaggedFloats (path, known);
}

cv::Mat
readDpt (const std::string& path)
{
  return readTaggedFloats (path, 1);
}

void
writeDpt (const std::string& path, const cv::Mat& depth)
{
  if (depth.type() != CV_32FC1 || depth.empty())
    throw IoError (path + ": depth: a CV_32FC1 image is needed");
  writeTaggedFloats (path, depth);
}

} // namespace pcl_msf::io
