// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/io/rgbd_images.h>

namespace pcl_msf::io {

double
colorUnit (const std::vector<const RgbdImages*>& frames)
{
  std::vector<cv::Mat> raw;
  for (const RgbdImages* frame : frames)
    if (!frame->raw_color.empty())
      raw.push_back (frame->raw_color.clone().reshape (1));
  if (raw.empty())
    return 1.0;
  // One factor serves all images, so that what becomes of 1 tells it.
  raw.emplace_back (1, 1, CV_32FC1, cv::Scalar (1.0));
  std::vector<cv::Mat*> images;
  for (cv::Mat& image : raw)
    images.push_back (&image);
  normalizeIntensity (images);
  return 1.0 / raw.back().at<float> (0, 0);
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
