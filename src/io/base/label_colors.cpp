// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/label_colors.h"

#include <pcl/common/colors.h>

namespace pcl_msf::io {

cv::Vec3b
labelColor (int label)
{
  const auto count = static_cast<int> (pcl::GlasbeyLUT::size());
  const pcl::RGB& color = pcl::GlasbeyLUT::at (label % count);
  return {color.b, color.g, color.r};
}

bool
onBoundary (const cv::Mat& labels, int row, int col)
{
  const int label = labels.at<int> (row, col);
  return (col + 1 < labels.cols && labels.at<int> (row, col + 1) != label) ||
         (row + 1 < labels.rows && labels.at<int> (row + 1, col) != label);
}

} // namespace pcl_msf::io
