// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/drawing.h"
#include <pcl_msf/io/figures.h>
#include <pcl_msf/io/flow_color.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf::io {

namespace {

bool
isKnown (const cv::Vec2f& flow)
{
  return std::isfinite (flow[0]) && std::isfinite (flow[1]);
}

} // namespace

cv::Mat
flowPicture (const cv::Mat& flow, double maximum)
{
  const double full = maximum > 0.0 ? maximum : flowLength (flow, 0.99);
  cv::Mat picture = flowColors (flow, full);
  const int side = std::min (picture.cols, picture.rows) / 6;
  if (side < 24)
    return picture;
  const std::string words = shortNumber (full) + " px";
  const int letters = std::max (9, side / 6);
  const int width = std::max (side, textWidth (words, letters) + 6);
  const cv::Rect place (0, 0, std::min (width, picture.cols), side + 2 * letters);
  picture (place).setTo (cv::Scalar::all (255));
  flowWheel (side).copyTo (
      picture (cv::Rect ((place.width - side) / 2, 0, side, side)));
  drawText (picture,
            words,
            {(width - textWidth (words, letters)) / 2, side + letters + letters / 2},
            letters,
            cv::Scalar::all (0));
  return picture;
}

FlickerPair
flickerPair (const cv::Mat& reference, const cv::Mat& current, const cv::Mat& flow)
{
  FlickerPair pair{asBgr (reference, flow.size()),
                   asBgr (warpToReference (current, flow), flow.size())};
  CV_Assert (pair.before.size() == flow.size());
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col)
      if (!isKnown (flow.at<cv::Vec2f> (row, col))) {
        pair.before.at<cv::Vec3b> (row, col) = {0, 0, 0};
        pair.after.at<cv::Vec3b> (row, col) = {0, 0, 0};
      }
  return pair;
}

} // namespace pcl_msf::io
