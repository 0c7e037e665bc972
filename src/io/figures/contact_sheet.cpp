// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "io/base/drawing.h"
#include <pcl_msf/io/figures.h>

#include <algorithm>

namespace pcl_msf::io {

namespace {

constexpr int kGap = 8;
constexpr int kTitle = 22;

cv::Mat
scaled (const cv::Mat& picture, int width)
{
  const double scale = static_cast<double> (width) / picture.cols;
  const int height = std::max (1, cvRound (picture.rows * scale));
  cv::Mat result;
  inThisThread ([&] {
    cv::resize (picture,
                result,
                {width, height},
                0.0,
                0.0,
                scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
  });
  return asBgr (result, {});
}

} // namespace

cv::Mat
contactSheet (const std::vector<LabelledPicture>& pictures, int columns, int width)
{
  CV_Assert (columns >= 1 && width >= 16 && !pictures.empty());
  std::vector<cv::Mat> tiles;
  int tallest = 0;
  for (const LabelledPicture& entry : pictures) {
    tiles.push_back (scaled (entry.picture, width));
    tallest = std::max (tallest, tiles.back().rows);
  }
  const int count = static_cast<int> (tiles.size());
  const int used_columns = std::min (columns, count);
  const int rows = (count + columns - 1) / columns;
  const int cell = kTitle + tallest + kGap;
  cv::Mat sheet (kGap + rows * cell,
                 kGap + used_columns * (width + kGap),
                 CV_8UC3,
                 cv::Scalar::all (255));
  for (int i = 0; i < count; ++i) {
    const cv::Point corner (kGap + (i % columns) * (width + kGap),
                            kGap + (i / columns) * cell);
    drawText (
        sheet, pictures[i].label, corner + cv::Point (0, 15), 12, cv::Scalar::all (0));
    tiles[i].copyTo (
        sheet (cv::Rect (corner + cv::Point (0, kTitle), tiles[i].size())));
  }
  return sheet;
}

} // namespace pcl_msf::io
