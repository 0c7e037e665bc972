// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/parallel_for.h"
#include <synthetic/lattice_noise.h>
#include <synthetic/noise_field.h>

#include <cmath>

namespace pcl_msf::synthetic {
namespace {

constexpr double reach = 6.0; ///< of the filter, correlation lengths

/** A decaying exponential whose squares sum up to one; the first element is largest. */
cv::Mat
decay (double length)
{
  const int count = 1 + static_cast<int> (std::ceil (reach * length));
  cv::Mat kernel (count, 1, CV_64FC1);
  for (int i = 0; i < count; ++i)
    kernel.at<double> (i) = std::exp (-i / length);
  return kernel / cv::norm (kernel);
}

} // namespace

std::uint64_t
pixelKey (std::uint64_t key, int u, int v, int channel)
{
  return mixed (key) + 4 * (static_cast<std::uint64_t> (v) * 65536 + u) + channel;
}

cv::Mat
correlatedNoise (
    const cv::Size& size, double length, std::uint64_t key, int channel, int threads)
{
  const cv::Mat kernel = length > 0.0 ? decay (length) : cv::Mat::ones (1, 1, CV_64FC1);
  const int border = kernel.rows - 1;
  cv::Mat field (size.height + border, size.width + border, CV_64FC1);
  parallelFor (threads, field.rows, 4, [&] (int v) {
    auto* row = field.ptr<double> (v);
    for (int u = 0; u < field.cols; ++u)
      row[u] = normalFrom (pixelKey (key, u, v, channel));
  });
  if (border > 0)
    withThreads (threads, [&] {
      const cv::Mat white = field.clone();
      cv::sepFilter2D (white, field, -1, kernel, kernel, cv::Point (0, 0));
    });
  return field (cv::Rect ({0, 0}, size));
}

cv::Mat
slowBends (const cv::Size& size, std::uint64_t key, int threads)
{
  const LatticeNoise noise (key);
  constexpr float cells = 4.0F; // of the lattice across the image
  constexpr double unit = 2.9;  // a lattice's rms is about 0.35
  cv::Mat bends (size, CV_64FC1);
  parallelFor (threads, size.height, 4, [&] (int v) {
    for (int u = 0; u < size.width; ++u) {
      const float scale = cells / static_cast<float> (size.width);
      bends.at<double> (v, u) = unit * noise ({scale * u, scale * v, 0.5F});
    }
  });
  return bends;
}

} // namespace pcl_msf::synthetic
