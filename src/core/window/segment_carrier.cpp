// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/window/segment_carrier.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

struct ZBuffer {
  cv::Mat inverse_depth; ///< CV_32FC1, 0 = nothing landed
  cv::Mat label;         ///< CV_32SC1
};

/** The nearest carried point of every pixel. In raster order, so that ties always go
 * the same way. */
ZBuffer
splat (const FrameLevel& reference,
       const cv::Mat& labels,
       const MotionState& motion,
       const FrameLevel& frame)
{
  const PinholeCamera& from = reference.camera;
  const PinholeCamera& to = frame.camera;
  std::vector<Eigen::Matrix3f> turns;
  std::vector<Eigen::Vector3f> shifts;
  for (const RigidPose& pose : motion.poses) {
    turns.emplace_back (pose.rotation().cast<float>());
    shifts.emplace_back (pose.translation().cast<float>());
  }
  ZBuffer buffer{cv::Mat::zeros (frame.height(), frame.width(), CV_32FC1),
                 cv::Mat (frame.height(), frame.width(), CV_32SC1, cv::Scalar (-1))};
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u) {
      const int k = labels.at<int> (v, u);
      const float w = reference.inverse_depth.at<float> (v, u);
      if (k < 0 || w <= 0.0f)
        continue;
      const int body = motion.body_of[k];
      const Eigen::Vector3f ray (static_cast<float> ((u - from.cx) / from.fx),
                                 static_cast<float> ((v - from.cy) / from.fy),
                                 1.0f);
      const Eigen::Vector3f q = turns[body] * ray + w * shifts[body]; // over depth
      if (!(q.z() > 0.0f))
        continue;
      const float carried = w / q.z();
      const auto x =
          static_cast<float> (to.fx) * q.x() / q.z() + static_cast<float> (to.cx);
      const auto y =
          static_cast<float> (to.fy) * q.y() / q.z() + static_cast<float> (to.cy);
      if (!(x > -0.5f && y > -0.5f && x < static_cast<float> (frame.width()) - 0.5f &&
            y < static_cast<float> (frame.height()) - 0.5f))
        continue;
      const int px = static_cast<int> (x + 0.5f);
      const int py = static_cast<int> (y + 0.5f);
      float& nearest = buffer.inverse_depth.at<float> (py, px);
      if (carried > nearest) {
        nearest = carried;
        buffer.label.at<int> (py, px) = k;
      }
    }
  return buffer;
}

/** Inverse depth that may lie between two points of one surface, a pixel apart. */
float
tolerance (float w, const NoiseModel& noise, const CarrierTuning& tuning)
{
  return static_cast<float> (tuning.sigmas * noise.inverse_depth) +
         static_cast<float> (tuning.relative_tolerance) * w;
}

/** Removes labels that do not lie on the frame's own surface. */
void
keepWhatIsSeen (const FrameLevel& frame,
                const NoiseModel& noise,
                const CarrierTuning& tuning,
                ZBuffer& buffer)
{
  for (int y = 0; y < buffer.label.rows; ++y)
    for (int x = 0; x < buffer.label.cols; ++x) {
      const float w = frame.inverse_depth.at<float> (y, x);
      const float carried = buffer.inverse_depth.at<float> (y, x);
      if (w <= 0.0f || std::abs (carried - w) > tolerance (w, noise, tuning))
        buffer.label.at<int> (y, x) = -1;
    }
}

/** Unlabelled pixels take the label beside them whose surface continues there. */
cv::Mat
closeGaps (const FrameLevel& frame,
           const NoiseModel& noise,
           const CarrierTuning& tuning,
           const cv::Mat& labels)
{
  cv::Mat result = labels.clone();
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      const float w = frame.inverse_depth.at<float> (y, x);
      if (labels.at<int> (y, x) >= 0 || w <= 0.0f)
        continue;
      int votes = 0;
      int found = -1;
      float best = tolerance (w, noise, tuning);
      for (const auto& [dx, dy] :
           {std::pair{-1, 0}, std::pair{1, 0}, std::pair{0, -1}, std::pair{0, 1}}) {
        const int u = x + dx;
        const int t = y + dy;
        if (u < 0 || t < 0 || u >= labels.cols || t >= labels.rows ||
            labels.at<int> (t, u) < 0)
          continue;
        ++votes;
        const float difference = std::abs (frame.inverse_depth.at<float> (t, u) - w);
        if (difference < best) {
          best = difference;
          found = labels.at<int> (t, u);
        }
      }
      if (votes >= 2) // a gap, not the open side of an uncovered region
        result.at<int> (y, x) = found;
    }
  return result;
}

} // namespace

cv::Mat
carryLabels (const FrameLevel& reference,
             const cv::Mat& labels,
             const MotionState& motion,
             const FrameLevel& frame,
             const NoiseModel& noise,
             const CarrierTuning& tuning)
{
  ZBuffer buffer = splat (reference, labels, motion, frame);
  keepWhatIsSeen (frame, noise, tuning, buffer);
  for (int round = 0; round < tuning.gap_rounds; ++round)
    buffer.label = closeGaps (frame, noise, tuning, buffer.label);
  return buffer.label;
}

} // namespace pcl_msf
