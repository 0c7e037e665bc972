// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/io/rgbd_images.h>

namespace pcl_msf::io {

double
colorUnit (const std::vector<const RgbdImages*>& frames)
{
  std::vector<cv::Mat> raw; // all channels as one image
  for (const RgbdImages* frame : frames)
    if (!frame->raw_color.empty())
      raw.push_back (frame->raw_color.reshape (1));
  std::vector<cv::Mat*> images;
  for (cv::Mat& image : raw)
    images.push_back (&image);
  return intensityUnit (images);
}

void
setColorUnit (RgbdImages& frame, double unit)
{
  if (frame.raw_color.empty())
    return;
  cv::Mat color; // not in place: copies of the frame share its image
  frame.raw_color.convertTo (color, CV_8U, 255.0 / unit);
  if (color.channels() == 1)
    cv::cvtColor (color, color, cv::COLOR_GRAY2BGR);
  frame.color = color;
}

void
unifyColors (const std::vector<RgbdImages*>& frames)
{
  const double unit = colorUnit ({frames.begin(), frames.end()});
  for (RgbdImages* frame : frames)
    setColorUnit (*frame, unit);
}

} // namespace pcl_msf::io
