// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/bilinear.h"
#include "io/base/drawing.h"
#include <pcl_msf/io/figures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_msf::io {

namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

/** Four pixels and their shares around a position, the border replicated. */
struct Neighborhood {
  Neighborhood (double u, double v, const cv::Size& size)
  {
    const double x = std::clamp (u, 0.0, size.width - 1.0);
    const double y = std::clamp (v, 0.0, size.height - 1.0);
    col = std::min (static_cast<int> (x), std::max (0, size.width - 2));
    row = std::min (static_cast<int> (y), std::max (0, size.height - 2));
    next_col = std::min (col + 1, size.width - 1);
    next_row = std::min (row + 1, size.height - 1);
    s = x - col;
    t = y - row;
  }
  int col, row, next_col, next_row;
  double s, t;
};

double
sample (const cv::Mat& image, const Neighborhood& at, int channel)
{
  const int step = image.channels();
  const unsigned char* top = image.ptr (at.row);
  const unsigned char* bottom = image.ptr (at.next_row);
  return bilinear<double, double> (at.s,
                                   at.t,
                                   top[at.col * step + channel],
                                   top[at.next_col * step + channel],
                                   bottom[at.col * step + channel],
                                   bottom[at.next_col * step + channel]);
}

bool
isKnown (const cv::Vec2f& flow)
{
  return std::isfinite (flow[0]) && std::isfinite (flow[1]);
}

} // namespace

cv::Mat
warpToReference (const cv::Mat& current, const cv::Mat& flow)
{
  CV_Assert (current.depth() == CV_8U && flow.type() == CV_32FC2);
  cv::Mat warped = cv::Mat::zeros (flow.size(), current.type());
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const auto& f = flow.at<cv::Vec2f> (row, col);
      if (!isKnown (f))
        continue;
      const Neighborhood at (col + f[0], row + f[1], current.size());
      unsigned char* pixel = warped.ptr (row) + col * warped.channels();
      for (int c = 0; c < warped.channels(); ++c)
        pixel[c] = cv::saturate_cast<unsigned char> (sample (current, at, c));
    }
  return warped;
}

cv::Mat
brightnessResidual (const cv::Mat& reference,
                    const cv::Mat& current,
                    const cv::Mat& flow)
{
  CV_Assert (reference.size() == flow.size() && flow.type() == CV_32FC2);
  const cv::Mat first = asGray (reference);
  const cv::Mat second = asGray (current);
  cv::Mat residual (flow.size(), CV_32FC1, cv::Scalar (kNan));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const auto& f = flow.at<cv::Vec2f> (row, col);
      if (!isKnown (f))
        continue;
      const Neighborhood at (col + f[0], row + f[1], second.size());
      const double there = sample (second, at, 0);
      residual.at<float> (row, col) =
          static_cast<float> (std::abs (first.at<unsigned char> (row, col) - there));
    }
  return residual;
}

cv::Mat
depthResidual (const SceneFlow& scene_flow, const cv::Mat& current_depth)
{
  CV_Assert (current_depth.type() == CV_32FC1);
  const cv::Mat& flow = scene_flow.flow;
  cv::Mat residual (flow.size(), CV_32FC1, cv::Scalar (kNan));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const auto& f = flow.at<cv::Vec2f> (row, col);
      if (!isKnown (f) || std::abs (f[0]) > 1e6F || std::abs (f[1]) > 1e6F)
        continue;
      const cv::Point at (cvRound (col + f[0]), cvRound (row + f[1]));
      if (!cv::Rect ({}, current_depth.size()).contains (at))
        continue;
      const float there = current_depth.at<float> (at);
      const float here = scene_flow.points.at<cv::Vec3f> (row, col)[2] +
                         scene_flow.displacement.at<cv::Vec3f> (row, col)[2];
      if (there > 0.0F && std::isfinite (there))
        residual.at<float> (row, col) = std::abs (here - there);
    }
  return residual;
}

cv::Mat
tintedOverlay (const cv::Mat& first, const cv::Mat& second)
{
  const cv::Mat a = asGray (first);
  const cv::Mat b = asGray (second);
  CV_Assert (a.size() == b.size());
  cv::Mat picture (a.size(), CV_8UC3);
  for (int row = 0; row < a.rows; ++row)
    for (int col = 0; col < a.cols; ++col) {
      const unsigned char x = a.at<unsigned char> (row, col);
      const unsigned char y = b.at<unsigned char> (row, col);
      const auto mean = static_cast<unsigned char> ((x + y) / 2);
      picture.at<cv::Vec3b> (row, col) = {y, mean, x};
    }
  return picture;
}

} // namespace pcl_msf::io
