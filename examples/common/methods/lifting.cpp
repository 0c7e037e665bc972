// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/methods/lifting.h"

#include "common/depth_points.h"
#include <pcl_msf/evaluation/residuals.h>

#include <cmath>
#include <limits>

namespace pcl_msf::tool {

namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

} // namespace

void
liftByDepth (const PairData& pair, Estimate& estimate)
{
  const cv::Mat points = pointsOf (pair.reference);
  estimate.lifted = true;
  estimate.displacement = cv::Mat (points.size(), CV_32FC3, cv::Scalar::all (kNan));
  for (int y = 0; y < points.rows; ++y)
    for (int x = 0; x < points.cols; ++x) {
      const cv::Vec3f p = points.at<cv::Vec3f> (y, x);
      const cv::Vec2f f = estimate.flow.at<cv::Vec2f> (y, x);
      if (!std::isfinite (p[2]) || !std::isfinite (f[0] + f[1]))
        continue;
      const float u = static_cast<float> (x) + f[0];
      const float v = static_cast<float> (y) + f[1];
      float z = evaluation::depthAt (pair.current.depth, u, v);
      if (z <= 0.0f)
        z = p[2];
      const Eigen::Vector3f q = pair.current.camera.backProject (u, v, z).cast<float>();
      estimate.displacement.at<cv::Vec3f> (y, x) = {
          q.x() - p[0], q.y() - p[1], q.z() - p[2]};
    }
}

void
moveRigidly (const PairData& pair, const RigidPose& pose, Estimate& estimate)
{
  const cv::Mat points = pointsOf (pair.reference);
  estimate.flow = cv::Mat (points.size(), CV_32FC2, cv::Scalar::all (kNan));
  estimate.displacement = cv::Mat (points.size(), CV_32FC3, cv::Scalar::all (kNan));
  estimate.dominant = pose;
  const Eigen::Matrix3d rotation = pose.rotation();
  for (int y = 0; y < points.rows; ++y)
    for (int x = 0; x < points.cols; ++x) {
      const cv::Vec3f p = points.at<cv::Vec3f> (y, x);
      if (!std::isfinite (p[2]))
        continue;
      const Eigen::Vector3d from (p[0], p[1], p[2]);
      const Eigen::Vector3d to = rotation * from + pose.translation();
      const Eigen::Vector3f d = (to - from).cast<float>();
      estimate.displacement.at<cv::Vec3f> (y, x) = {d.x(), d.y(), d.z()};
      if (to.z() <= 0.0)
        continue;
      const Eigen::Vector2d pixel = pair.current.camera.project (to);
      estimate.flow.at<cv::Vec2f> (y, x) = {static_cast<float> (pixel.x() - x),
                                            static_cast<float> (pixel.y() - y)};
    }
}

} // namespace pcl_msf::tool
