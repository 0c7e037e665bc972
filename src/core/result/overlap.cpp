// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/overlap.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr int kAround = 9;           // pixels, side of the surroundings
constexpr float kSignificant = 3.0f; // standard deviations of the noise

/** Intensity against the mean around it; empty without intensity. */
cv::Mat
contrastOf (const RgbdFrame& frame)
{
  const cv::Mat& intensity = frame.levels()[0].intensity;
  cv::Mat contrast;
  if (intensity.empty())
    return contrast;
  cv::blur (intensity, contrast, {kAround, kAround});
  contrast = intensity - contrast;
  return contrast;
}

float
bilinear (const cv::Mat& image, float x, float y)
{
  x = std::clamp (x, 0.0f, static_cast<float> (image.cols - 1));
  y = std::clamp (y, 0.0f, static_cast<float> (image.rows - 1));
  const int x0 = std::min (static_cast<int> (x), image.cols - 2);
  const int y0 = std::min (static_cast<int> (y), image.rows - 2);
  const float a = x - static_cast<float> (x0);
  const float b = y - static_cast<float> (y0);
  const float* const top = image.ptr<float> (y0) + x0;
  const float* const low = image.ptr<float> (y0 + 1) + x0;
  return (1.0f - b) * ((1.0f - a) * top[0] + a * top[1]) +
         b * ((1.0f - a) * low[0] + a * low[1]);
}

/** Counts a visible point whose contrast says something. */
void
compareContrast (float before, float after, float least, Overlap& overlap)
{
  const float smaller = std::min (std::abs (before), std::abs (after));
  const float larger = std::max (std::abs (before), std::abs (after));
  if (!(smaller > least) && !(larger > 2.0f * least))
    return;
  ++overlap.contrasts;
  overlap.alike += before * after > 0.0f ? 1 : 0;
}

} // namespace

Overlap
measureOverlap (const RgbdFrame& reference,
                const RgbdFrame& current,
                double intensity_noise,
                const SceneFlow& flow)
{
  const cv::Mat before = contrastOf (reference);
  const cv::Mat after = contrastOf (current);
  const cv::Mat& depth = current.levels()[0].inverse_depth;
  const auto least = kSignificant * static_cast<float> (intensity_noise);
  Overlap overlap;
  for (int v = 0; v < flow.flow.rows; ++v)
    for (int u = 0; u < flow.flow.cols; ++u) {
      const auto seen = flow.visibility.at<unsigned char> (v, u);
      const cv::Vec2f& way = flow.flow.at<cv::Vec2f> (v, u);
      overlap.points += seen != NoDepth ? 1 : 0;
      if (!std::isfinite (way[0]) || !std::isfinite (way[1]))
        continue;
      ++overlap.moved;
      if (seen == OutOfView)
        continue;
      const float x = static_cast<float> (u) + way[0];
      const float y = static_cast<float> (v) + way[1];
      const int column = std::clamp (cvRound (x), 0, depth.cols - 1);
      const int row = std::clamp (cvRound (y), 0, depth.rows - 1);
      overlap.landed += depth.at<float> (row, column) > 0.0f ? 1 : 0;
      if (seen != Visible)
        continue;
      ++overlap.found;
      if (!before.empty() && !after.empty())
        compareContrast (
            before.at<float> (v, u), bilinear (after, x, y), least, overlap);
    }
  return overlap;
}

} // namespace pcl_msf
