// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/deviations.h"

#include "core/base/parallel_for.h"
#include "core/result/pose_covariance.h"

#include <cmath>
#include <limits>

namespace pcl_msf {

namespace {

/** Expected squared lengths of a point's errors. */
struct Variance {
  double flow{0.0};         ///< square pixels
  double displacement{0.0}; ///< square metres
};

/** Carries a segment's covariance to its points. */
class SegmentVariance {
public:
  SegmentVariance (const RigidPose& pose,
                   const Matrix6& covariance,
                   const PinholeCamera& camera,
                   double inverse_depth_noise)
  : rotation_ (pose.rotation())
  , translation_ (pose.translation())
  , left_jacobian_ (
        leftJacobian ({pose.parameters[0], pose.parameters[1], pose.parameters[2]}))
  , covariance_ (covariance)
  , camera_ (camera)
  , noise_ (inverse_depth_noise)
  {}

  Variance
  at (const Eigen::Vector3d& point) const
  {
    const Eigen::Vector3d turned = rotation_ * point;
    const Eigen::Vector3d moved = turned + translation_;
    const Eigen::Matrix<double, 3, 6> j = pointJacobian (left_jacobian_, turned);
    const Eigen::Matrix3d spread = j * covariance_ * j.transpose();
    const Eigen::Matrix<double, 2, 3> image = projection (moved);
    // Another inverse depth takes the point along its ray.
    const double along = point.z() * noise_;
    const Eigen::Vector3d ahead = along * turned;
    return {(image * spread * image.transpose()).trace() +
                (image * ahead).squaredNorm(),
            spread.trace() + (ahead - along * point).squaredNorm()};
  }

private:
  /** d (pixel) / d (point); of points at the camera nothing is known. */
  Eigen::Matrix<double, 2, 3>
  projection (const Eigen::Vector3d& q) const
  {
    const double w = q.z() > 1e-3 ? 1.0 / q.z() : std::nan ("");
    Eigen::Matrix<double, 2, 3> j;
    j << camera_.fx * w, 0.0, -camera_.fx * q.x() * w * w, 0.0, camera_.fy * w,
        -camera_.fy * q.y() * w * w;
    return j;
  }

  Eigen::Matrix3d rotation_;
  Eigen::Vector3d translation_;
  Eigen::Matrix3d left_jacobian_;
  Matrix6 covariance_;
  const PinholeCamera& camera_;
  double noise_;
};

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
      const Variance step = differenceAround (result, at, radii);
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
