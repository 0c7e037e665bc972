// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/label_refill.h"

#include <algorithm>
#include <map>

namespace pcl_msf {

double
labelledShare (const cv::Mat& labels, const cv::Mat& inverse_depth)
{
  const cv::Mat measured = inverse_depth > 0.0f;
  const double labelled = cv::countNonZero ((labels >= 0) & measured);
  return labelled / std::max (1, cv::countNonZero (measured));
}

cv::Mat
fillWithFresh (const cv::Mat& labels, const Oversegmentation& fresh, int first_fresh)
{
  std::vector<std::map<int, int>> votes (fresh.size());
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (const int f = fresh.labels().at<int> (y, x); f >= 0)
        ++votes[f][std::max (-1, labels.at<int> (y, x))];
  std::vector<int> winner (fresh.size());
  for (int f = 0; f < fresh.size(); ++f) {
    const auto most = std::max_element (
        votes[f].begin(), votes[f].end(), [] (const auto& a, const auto& b) {
          return a.second < b.second;
        });
    winner[f] = most->first >= 0 ? most->first : first_fresh + f;
  }
  cv::Mat result = labels.clone();
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (const int f = fresh.labels().at<int> (y, x);
          f >= 0 && labels.at<int> (y, x) < 0)
        result.at<int> (y, x) = winner[f];
  return result;
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
