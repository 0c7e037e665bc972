// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/errors.h>
#include <pcl_msf/io/result_files.h>

#include <algorithm>
#include <vector>

namespace pcl_msf::io {

cv::Mat
groupImage (const SceneFlow& flow)
{
  const int segments = static_cast<int> (flow.segments.size());
  cv::Mat groups (flow.labels.size(), CV_32SC1, cv::Scalar (-1));
  for (int row = 0; row < groups.rows; ++row)
    for (int col = 0; col < groups.cols; ++col) {
      const int label = flow.labels.at<int> (row, col);
      if (label >= 0 && label < segments &&
          flow.segments[label].status != MotionStatus::Undetermined)
        groups.at<int> (row, col) = flow.segments[label].group;
    }
  return groups;
}

void
setGroups (const cv::Mat& groups, SceneFlow& flow)
{
  if (groups.type() != CV_32SC1 || groups.size() != flow.labels.size())
    throw InvalidInput ("motion groups: the image is " + std::to_string (groups.cols) +
                        "x" + std::to_string (groups.rows) + ", the scene flow " +
                        std::to_string (flow.labels.cols) + "x" +
                        std::to_string (flow.labels.rows) +
                        "; give the CV_32SC1 image that belongs to it");
  for (SegmentMotion& segment : flow.segments)
    segment.group = -1;
  for (int row = groups.rows - 1; row >= 0; --row)
    for (int col = groups.cols - 1; col >= 0; --col) {
      const int label = flow.labels.at<int> (row, col);
      if (label >= 0 && label < static_cast<int> (flow.segments.size()))
        flow.segments[label].group = groups.at<int> (row, col);
    }
  flow.groups = 0;
  for (const SegmentMotion& segment : flow.segments)
    flow.groups = std::max (flow.groups, segment.group + 1);
  std::vector<long> points (flow.groups, 0);
  for (const SegmentMotion& segment : flow.segments)
    if (segment.group >= 0)
      points[segment.group] += segment.points;
  flow.dominant_group =
      flow.groups > 0
          ? static_cast<int> (std::max_element (points.begin(), points.end()) -
                              points.begin())
          : -1;
}

} // namespace pcl_msf::io
