// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/motion_ranks.h"

#include <algorithm>
#include <numeric>

namespace pcl_msf::io {

MotionRanks::MotionRanks (const SceneFlow& flow)
{
  const int groups = std::max (0, flow.groups);
  std::vector<long> points (groups, 0);
  for (const SegmentMotion& segment : flow.segments) {
    all_points_ += segment.points;
    if (segment.group >= 0 && segment.group < groups)
      points[segment.group] += segment.points;
  }
  std::vector<int> order (groups);
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (order.begin(), order.end(), [&] (int a, int b) {
    if ((a == flow.dominant_group) != (b == flow.dominant_group))
      return a == flow.dominant_group;
    return points[a] > points[b];
  });
  std::vector<int> rank (groups);
  for (int i = 0; i < groups; ++i) {
    rank[order[i]] = i;
    points_.push_back (points[order[i]]);
  }
  for (const SegmentMotion& segment : flow.segments) {
    const bool known = segment.status != MotionStatus::Undetermined &&
                       segment.group >= 0 && segment.group < groups;
    rank_of_.push_back (known ? rank[segment.group] : groups);
  }
}

int
MotionRanks::rank (int label) const
{
  const bool known = label >= 0 && label < static_cast<int> (rank_of_.size());
  return known ? rank_of_[label] : -1;
}

cv::Mat
MotionRanks::image (const cv::Mat& labels) const
{
  cv::Mat ranks (labels.size(), CV_32SC1);
  for (int row = 0; row < labels.rows; ++row)
    for (int col = 0; col < labels.cols; ++col)
      ranks.at<int> (row, col) = rank (labels.at<int> (row, col));
  return ranks;
}

} // namespace pcl_msf::io
