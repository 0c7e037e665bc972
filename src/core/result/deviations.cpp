// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/deviations.h"

#include <Eigen/Geometry>

#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/parallel_for.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace pcl_msf {

namespace {

/** Expected squared lengths of a point's errors. */
struct Variance {
  double flow{0.0};         ///< square pixels
  double displacement{0.0}; ///< square metres
};

/** Carries a segment's covariance to its points: traces of J C J' with J = (-[q]x L, 1)
 * as from pointJacobian, by the blocks of C. */
class SegmentVariance {
public:
  SegmentVariance (const RigidPose& pose,
                   const Matrix6& covariance,
                   const PinholeCamera& camera,
                   double inverse_depth_noise)
  : rotation_ (pose.rotation())
  , translation_ (pose.translation())
  , camera_ (camera)
  , noise_ (inverse_depth_noise)
  {
    const Eigen::Matrix3d left =
        leftJacobian ({pose.parameters[0], pose.parameters[1], pose.parameters[2]});
    turning_ = left * covariance.topLeftCorner<3, 3>() * left.transpose();
    both_ = left * covariance.topRightCorner<3, 3>();
    moving_ = covariance.bottomRightCorner<3, 3>();
    twist_ = {both_ (1, 2) - both_ (2, 1),
              both_ (2, 0) - both_ (0, 2),
              both_ (0, 1) - both_ (1, 0)};
  }

  Variance
  at (const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d turned = rotation_ * point;
    const Eigen::Vector3d moved = turned + translation_;
    // Another inverse depth takes the point along its ray.
    const double along = point.z() * noise_;
    const Eigen::Vector3d ahead = along * turned;
    const double w = moved.z() > 1e-3 ? 1.0 / moved.z() : std::nan ("");
    const Eigen::Vector3d u (camera_.fx * w, 0.0, -camera_.fx * moved.x() * w * w);
    const Eigen::Vector3d v (0.0, camera_.fy * w, -camera_.fy * moved.y() * w * w);
    return {alongGradient (u, turned) + alongGradient (v, turned) +
                std::pow (u.dot (ahead), 2) + std::pow (v.dot (ahead), 2),
            turned.squaredNorm() * turning_.trace() - turned.dot (turning_ * turned) -
                2.0 * turned.dot (twist_) + moving_.trace() +
                (ahead - along * point).squaredNorm()};
  }

private:
  /** g' J C J' g: variance of g . (moved point); NaN at the camera, as g is. */
  double
  alongGradient (const Eigen::Vector3d& g, const Eigen::Vector3d& turned) const
  {
    const Eigen::Vector3d h = g.cross (turned);
    return h.dot (turning_ * h) - 2.0 * h.dot (both_ * g) + g.dot (moving_ * g);
  }

  Eigen::Matrix3d rotation_;
  Eigen::Vector3d translation_;
  Eigen::Matrix3d turning_, both_, moving_; ///< blocks of the covariance, turned
  Eigen::Vector3d twist_;                   ///< with q . twist = trace ([q]x both)
  const PinholeCamera& camera_;
  double noise_;
};

/** Where motions differ within a radius: 255 in CV_8UC1. Inside of a rigid body they
 * hardly do. */
cv::Mat
nearOtherMotions (const SceneFlow& scene, int radius)
{
  std::map<std::array<double, 6>, int> motions;
  std::vector<float> motion_of;
  for (const SegmentMotion& segment : scene.segments) {
    const auto next = static_cast<int> (motions.size());
    motion_of.push_back (static_cast<float> (
        motions.try_emplace (segment.current_from_reference.parameters, next)
            .first->second));
  }
  cv::Mat motion (scene.labels.size(), CV_32FC1);
  for (int y = 0; y < motion.rows; ++y)
    for (int x = 0; x < motion.cols; ++x) {
      const int label = scene.labels.at<int> (y, x);
      motion.at<float> (y, x) = label < 0 ? -1.0f : motion_of[label];
    }
  cv::Mat lowest, highest;
  const cv::Mat window = cv::Mat::ones (2 * radius + 1, 2 * radius + 1, CV_8UC1);
  inThisThread ([&] {
    cv::erode (motion, lowest, window);
    cv::dilate (motion, highest, window);
  });
  return lowest != highest;
}

/** Mean squared difference of the motion from those around a pixel: two rings of eight,
 * the outer half as likely. */
Variance
differenceAround (const SceneFlow& scene, const cv::Point& at, const int (&radii)[2])
{
  const cv::Vec2f flow = scene.flow.at<cv::Vec2f> (at);
  const cv::Vec3f displacement = scene.displacement.at<cv::Vec3f> (at);
  const cv::Rect image ({}, scene.flow.size());
  Variance sum;
  double weights = 0.0;
  for (int ring = 0; ring < 2; ++ring)
    for (int i = 0; i < 9; ++i) {
      const cv::Point other = at + radii[ring] * cv::Point (i % 3 - 1, i / 3 - 1);
      if (i == 4 || !image.contains (other))
        continue;
      const cv::Vec2f f = scene.flow.at<cv::Vec2f> (other) - flow;
      const double d = f.dot (f);
      if (!std::isfinite (d))
        continue;
      const double weight = ring == 0 ? 1.0 : 0.5;
      sum.flow += weight * d;
      const cv::Vec3f way = scene.displacement.at<cv::Vec3f> (other) - displacement;
      sum.displacement += weight * way.dot (way);
      weights += weight;
    }
  if (weights > 0.0)
    return {sum.flow / weights, sum.displacement / weights};
  return {};
}

} // namespace

void
fillDeviations (const SegmentPixels& p,
                const std::vector<Matrix6>& covariances,
                const PinholeCamera& camera,
                double inverse_depth_noise,
                const DeviationTuning& tuning,
                int threads,
                SceneFlow& result)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const cv::Size size = result.labels.size();
  result.flow_deviation = cv::Mat (size, CV_32FC1, cv::Scalar::all (nan));
  result.displacement_deviation = cv::Mat (size, CV_32FC1, cv::Scalar::all (nan));
  const int radii[2] = {tuning.near_step, tuning.far_step};
  const cv::Mat near_others = nearOtherMotions (result, tuning.far_step);
  parallelFor (threads, p.segments(), 8, [&] (int k) {
    const SegmentVariance own (result.segments[k].current_from_reference,
                               covariances[k],
                               camera,
                               inverse_depth_noise);
    for (int i = p.begin[k]; i < p.begin[k + 1]; ++i) {
      const cv::Point at (p.pixel[i] % size.width, p.pixel[i] / size.width);
      if (std::isnan (result.displacement.at<cv::Vec3f> (at)[0]))
        continue;
      const Variance pose = own.at ({p.x[i], p.y[i], p.z[i]});
      const Variance step = near_others.at<unsigned char> (at) != 0
                                ? differenceAround (result, at, radii)
                                : Variance{};
      const bool seen = result.visibility.at<unsigned char> (at) == Visible;
      const double across = seen ? tuning.across : tuning.across_unseen;
      const double pixel = tuning.least_pixels * p.z[i] / camera.fx;
      result.displacement_deviation.at<float> (at) = static_cast<float> (
          std::sqrt (pose.displacement + across * step.displacement + pixel * pixel));
      if (!std::isnan (result.flow.at<cv::Vec2f> (at)[0]))
        result.flow_deviation.at<float> (at) =
            static_cast<float> (std::sqrt (pose.flow + across * step.flow +
                                           tuning.least_pixels * tuning.least_pixels));
    }
  });
}

} // namespace pcl_msf
