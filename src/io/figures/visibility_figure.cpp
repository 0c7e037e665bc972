// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "io/base/drawing.h"
#include <pcl_msf/io/figures.h>

#include <array>

namespace pcl_msf::io {

namespace {

constexpr int kLegendHeight = 22;

/** How one kind of visibility is shown. */
struct Kind {
  Visibility code;
  const char* name;
  cv::Vec3b color;
};

const std::array<Kind, 4> kKinds{{{Visibility::NoDepth, "no depth", {0, 0, 0}},
                                  {Visibility::OutOfView, "out of view", {230, 90, 30}},
                                  {Visibility::Occluded, "occluded", {40, 40, 230}},
                                  {Visibility::Unknown, "unknown", {40, 210, 230}}}};

void
drawLegend (cv::Mat& picture, int top)
{
  int x = 8;
  for (const Kind& kind : kKinds) {
    cv::rectangle (picture, {x, top + 5, 12, 12}, cv::Scalar (kind.color), cv::FILLED);
    x += 16;
    x += drawText (picture, kind.name, {x, top + 16}, 10, cv::Scalar::all (0)) + 14;
  }
}

} // namespace

cv::Mat
visibilityPicture (const cv::Mat& image, const cv::Mat& visibility)
{
  CV_Assert (visibility.type() == CV_8UC1);
  cv::Mat picture;
  cv::copyMakeBorder (asBgr (image, visibility.size()),
                      picture,
                      0,
                      kLegendHeight,
                      0,
                      0,
                      cv::BORDER_CONSTANT,
                      cv::Scalar::all (255));
  for (int row = 0; row < visibility.rows; ++row)
    for (int col = 0; col < visibility.cols; ++col)
      for (const Kind& kind : kKinds)
        if (visibility.at<unsigned char> (row, col) == kind.code)
          picture.at<cv::Vec3b> (row, col) = kind.color;
  drawLegend (picture, visibility.rows);
  return picture;
}

} // namespace pcl_msf::io
