// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "evaluation/check_images.h"
#include <pcl_msf/evaluation/motion_errors.h>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace pcl_msf::evaluation {

namespace {

/** How many pixels are in each pair of sets. */
struct Contingency {
  std::map<std::pair<int, int>, double> both;
  std::map<int, double> first, second;
  double pixels{0.0};

  Contingency (const cv::Mat& a, const cv::Mat& b)
  {
    requireImage ("first partition", a, CV_32SC1, a.size());
    requireImage ("second partition", b, CV_32SC1, a.size());
    for (int y = 0; y < a.rows; ++y)
      for (int x = 0; x < a.cols; ++x) {
        const int i = a.at<int> (y, x), j = b.at<int> (y, x);
        if (i < 0 || j < 0)
          continue;
        both[{i, j}] += 1.0;
        first[i] += 1.0;
        second[j] += 1.0;
        pixels += 1.0;
      }
  }
};

double
pairsOf (double n)
{
  return 0.5 * n * (n - 1.0);
}

template <typename Counts>
double
sumOfPairs (const Counts& counts)
{
  double sum = 0.0;
  for (const auto& [set, n] : counts)
    sum += pairsOf (n);
  return sum;
}

} // namespace

double
adjustedRandIndex (const cv::Mat& a, const cv::Mat& b)
{
  const Contingency table (a, b);
  if (table.pixels < 2.0)
    return std::numeric_limits<double>::quiet_NaN();
  const double together = sumOfPairs (table.both);
  const double first = sumOfPairs (table.first);
  const double second = sumOfPairs (table.second);
  const double expected = first * second / pairsOf (table.pixels);
  const double largest = 0.5 * (first + second);
  if (largest == expected) // both one set, or both singletons
    return 1.0;
  return (together - expected) / (largest - expected);
}

double
groupPurity (const cv::Mat& groups, const cv::Mat& labels)
{
  const Contingency table (groups, labels);
  if (table.pixels == 0.0)
    return std::numeric_limits<double>::quiet_NaN();
  std::map<int, double> most;
  for (const auto& [sets, n] : table.both)
    most[sets.first] = std::max (most[sets.first], n);
  double sum = 0.0;
  for (const auto& [group, n] : most)
    sum += n;
  return sum / table.pixels;
}

cv::Mat
motionGroups (const SceneFlow& estimate)
{
  cv::Mat groups (estimate.labels.size(), CV_32SC1, cv::Scalar (-1));
  for (int y = 0; y < groups.rows; ++y)
    for (int x = 0; x < groups.cols; ++x) {
      const int k = estimate.labels.at<int> (y, x);
      if (k >= 0)
        groups.at<int> (y, x) = estimate.segments[k].group;
    }
  return groups;
}

} // namespace pcl_msf::evaluation
