// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/drawing.h"

#include <opencv2/imgproc.hpp>

#include "core/base/number_text.h"
#include "core/base/opencv_threads.h"

#include <algorithm>

namespace pcl_msf::io {

namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kFontPixels = 22.0; ///< height of the font's capitals at scale 1

/** Thickness that goes with a height. */
int
strokes (int height)
{
  return std::max (1, cvRound (height / 11.0));
}

} // namespace

cv::Mat
asBgr (const cv::Mat& image, const cv::Size& size)
{
  if (image.empty())
    return {size, CV_8UC3, cv::Scalar::all (128)};
  CV_Assert (image.depth() == CV_8U &&
             (image.channels() == 1 || image.channels() == 3));
  cv::Mat bgr;
  if (image.channels() == 1)
    inThisThread ([&] { cv::cvtColor (image, bgr, cv::COLOR_GRAY2BGR); });
  else
    image.copyTo (bgr);
  return bgr;
}

cv::Mat
asGray (const cv::Mat& image)
{
  if (image.channels() == 1)
    return image;
  cv::Mat gray;
  inThisThread ([&] { cv::cvtColor (image, gray, cv::COLOR_BGR2GRAY); });
  return gray;
}

int
drawText (cv::Mat& picture,
          const std::string& text,
          const cv::Point& origin,
          int height,
          const cv::Scalar& color)
{
  cv::putText (picture,
               text,
               origin,
               kFont,
               height / kFontPixels,
               color,
               strokes (height),
               cv::LINE_AA);
  return textWidth (text, height);
}

int
textWidth (const std::string& text, int height)
{
  int baseline = 0;
  return cv::getTextSize (
             text, kFont, height / kFontPixels, strokes (height), &baseline)
      .width;
}

std::string
shortNumber (double number)
{
  return generalText (number, 3);
}

} // namespace pcl_msf::io
