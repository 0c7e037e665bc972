// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/errors.h>
#include <pcl_msf/io/result_files.h>

#include <algorithm>
#include <vector>

namespace pcl_msf::io {

cv::Mat
bodyImage (const SceneFlow& flow)
{
  const int segments = static_cast<int> (flow.segments.size());
  cv::Mat bodies (flow.labels.size(), CV_32SC1, cv::Scalar (-1));
  for (int row = 0; row < bodies.rows; ++row)
    for (int col = 0; col < bodies.cols; ++col) {
      const int label = flow.labels.at<int> (row, col);
      if (label >= 0 && label < segments &&
          flow.segments[label].status != MotionStatus::Undetermined)
        bodies.at<int> (row, col) = flow.segments[label].body;
    }
  return bodies;
}

void
setBodies (const cv::Mat& bodies, SceneFlow& flow)
{
  if (bodies.type() != CV_32SC1 || bodies.size() != flow.labels.size())
    throw InvalidInput ("motion groups: the image is " + std::to_string (bodies.cols) +
                        "x" + std::to_string (bodies.rows) + ", the scene flow " +
                        std::to_string (flow.labels.cols) + "x" +
                        std::to_string (flow.labels.rows) +
                        "; give the CV_32SC1 image that belongs to it");
  for (SegmentMotion& segment : flow.segments)
    segment.body = -1;
  for (int row = bodies.rows - 1; row >= 0; --row)
    for (int col = bodies.cols - 1; col >= 0; --col) {
      const int label = flow.labels.at<int> (row, col);
      if (label >= 0 && label < static_cast<int> (flow.segments.size()))
        flow.segments[label].body = bodies.at<int> (row, col);
    }
  flow.bodies = 0;
  for (const SegmentMotion& segment : flow.segments)
    flow.bodies = std::max (flow.bodies, segment.body + 1);
  std::vector<long> points (flow.bodies, 0);
  for (const SegmentMotion& segment : flow.segments)
    if (segment.body >= 0)
      points[segment.body] += segment.points;
  flow.dominant_body =
      flow.bodies > 0
          ? static_cast<int> (std::max_element (points.begin(), points.end()) -
                              points.begin())
          : -1;
}

} // namespace pcl_msf::io
