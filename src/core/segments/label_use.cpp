// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/label_use.h"

#include <algorithm>

namespace pcl_msf {

double
labelledShare (const cv::Mat& labels, const cv::Mat& inverse_depth)
{
  const cv::Mat measured = inverse_depth > 0.0f;
  const double labelled = cv::countNonZero ((labels >= 0) & measured);
  return labelled / std::max (1, cv::countNonZero (measured));
}

std::vector<int>
labelsInOrder (const cv::Mat& labels, const cv::Mat& inverse_depth)
{
  std::vector<int> found;
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (labels.at<int> (y, x) >= 0 && inverse_depth.at<float> (y, x) > 0.0f)
        found.push_back (labels.at<int> (y, x));
  std::sort (found.begin(), found.end());
  found.erase (std::unique (found.begin(), found.end()), found.end());
  return found;
}

} // namespace pcl_msf
