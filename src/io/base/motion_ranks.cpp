// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/motion_ranks.h"

#include <algorithm>
#include <numeric>

namespace pcl_msf::io {

MotionRanks::MotionRanks (const SceneFlow& flow)
{
  const int bodies = std::max (0, flow.bodies);
  std::vector<long> points (bodies, 0);
  for (const SegmentMotion& segment : flow.segments) {
    all_points_ += segment.points;
    if (segment.body >= 0 && segment.body < bodies)
      points[segment.body] += segment.points;
  }
  std::vector<int> order (bodies);
  std::iota (order.begin(), order.end(), 0);
  std::stable_sort (order.begin(), order.end(), [&] (int a, int b) {
    if ((a == flow.dominant_body) != (b == flow.dominant_body))
      return a == flow.dominant_body;
    return points[a] > points[b];
  });
  std::vector<int> rank (bodies);
  for (int i = 0; i < bodies; ++i) {
    rank[order[i]] = i;
    points_.push_back (points[order[i]]);
  }
  for (const SegmentMotion& segment : flow.segments) {
    const bool known = segment.status != MotionStatus::Undetermined &&
                       segment.body >= 0 && segment.body < bodies;
    rank_of_.push_back (known ? rank[segment.body] : bodies);
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
