// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "core/base/parallel_for.h"

#include <algorithm>
#include <limits>

namespace pcl_msf {

/** \brief An image of NaN in all channels, CV_32F. Threads share the rows: the first
 * touch of its memory takes most of the time. */
inline cv::Mat
unknownImage (const cv::Size& size, int channels, int threads)
{
  cv::Mat image (size, CV_32FC (channels));
  parallelFor (threads, size.height, 32, [&] (int y) {
    std::fill_n (image.ptr<float> (y),
                 size.width * channels,
                 std::numeric_limits<float>::quiet_NaN());
  });
  return image;
}

} // namespace pcl_msf
