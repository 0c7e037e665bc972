// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/result/deviations.h"

#include <Eigen/Geometry>

#include <opencv2/imgproc.hpp>

#include "core/base/opencv_threads.h"
#include "core/base/parallel_for.h"
#include "core/result/unknown_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace pcl_msf {

namespace {

/** Expected squared lengths of a point's errors. */
struct Variance {
  float flow{0.0f};         ///< square pixels
  float displacement{0.0f}; ///< square metres
};

constexpr int kBlock = 256; // points that are carried at once

/** Variances of a block of points, side by side. */
struct BlockVariances {
  std::array<float, kBlock> flow; ///< NaN behind the camera
  std::array<float, kBlock> displacement;
};

/** x' S x of a symmetric matrix. */
inline float
quadratic (const Eigen::Matrix3f& s, float x, float y, float z)
{
  return x * (s (0, 0) * x + 2.0f * (s (0, 1) * y + s (0, 2) * z)) +
         y * (s (1, 1) * y + 2.0f * s (1, 2) * z) + z * s (2, 2) * z;
}

/** Carries a segment's covariance to its points: traces of J C J' with J = (-[q]x, 1)
 * as from pointJacobian, by the blocks of C. Lengths are from the segment's centroid,
 * so that floats are enough. */
class SegmentVariance {
public:
  SegmentVariance (const RigidPose& pose,
                   const Matrix6& covariance,
                   const Eigen::Vector3d& centroid,
                   const PinholeCamera& camera,
                   double inverse_depth_noise)
  : rotation_ (pose.rotation().cast<float>())
  , centroid_ (centroid.cast<float>())
  , turned_centroid_ ((pose.rotation() * centroid).cast<float>())
  , translation_ (pose.translation().cast<float>())
  , fx_ (static_cast<float> (camera.fx))
  , fy_ (static_cast<float> (camera.fy))
  , noise_ (static_cast<float> (inverse_depth_noise))
  {
    const Eigen::Matrix3d left =
        leftJacobian ({pose.parameters[0], pose.parameters[1], pose.parameters[2]});
    const Eigen::Vector3d c = pose.rotation() * centroid;
    Eigen::Matrix3d lever; // [c]x
    lever << 0.0, -c.z(), c.y(), c.z(), 0.0, -c.x(), -c.y(), c.x(), 0.0;
    const Eigen::Matrix3d turning =
        left * covariance.topLeftCorner<3, 3>() * left.transpose();
    const Eigen::Matrix3d far = left * covariance.topRightCorner<3, 3>();
    const Eigen::Matrix3d both = far + turning * lever;
    const Eigen::Matrix3d moving =
        covariance.bottomRightCorner<3, 3>() - lever * far +
        (far.transpose() - lever * turning.transpose()) * lever;
    turning_ = turning.cast<float>();
    both_ = both.cast<float>();
    moving_ = (0.5 * (moving + moving.transpose())).cast<float>();
    twist_ = {both_ (1, 2) - both_ (2, 1),
              both_ (2, 0) - both_ (0, 2),
              both_ (0, 1) - both_ (1, 0)};
  }

  /** Of points [first, first + count), count <= kBlock. */
  void
  carry (const SegmentPixels& p, int first, int count, BlockVariances& out) const
  {
    const float* const x = p.x.data() + first;
    const float* const y = p.y.data() + first;
    const float* const z = p.z.data() + first;
#pragma omp simd
    for (int i = 0; i < count; ++i)
      carry (x[i], y[i], z[i], out.flow[i], out.displacement[i]);
  }

private:
  [[gnu::always_inline]] void
  carry (float x, float y, float z, float& flow, float& displacement) const
  {
    const Eigen::Matrix3f& r = rotation_;
    const float ox = x - centroid_.x(), oy = y - centroid_.y(), oz = z - centroid_.z();
    const float qx = r (0, 0) * ox + r (0, 1) * oy + r (0, 2) * oz;
    const float qy = r (1, 0) * ox + r (1, 1) * oy + r (1, 2) * oz;
    const float qz = r (2, 0) * ox + r (2, 1) * oy + r (2, 2) * oz;
    const float tx = qx + turned_centroid_.x(), ty = qy + turned_centroid_.y(),
                tz = qz + turned_centroid_.z();
    // Another inverse depth takes the point along its ray.
    const float along = z * noise_;
    const float mz = tz + translation_.z();
    const float w = mz > 1e-3f ? 1.0f / mz : std::numeric_limits<float>::quiet_NaN();
    const float a = fx_ * w, c = -a * (tx + translation_.x()) * w; // d u / d (x, z)
    const float b = fy_ * w, d = -b * (ty + translation_.y()) * w; // d v / d (y, z)
    const float ahead_u = along * (a * tx + c * tz);
    const float ahead_v = along * (b * ty + d * tz);
    flow = alongGradient (a, 0.0f, c, -c * qy, c * qx - a * qz, a * qy) +
           alongGradient (0.0f, b, d, b * qz - d * qy, d * qx, -b * qx) +
           ahead_u * ahead_u + ahead_v * ahead_v;
    const float ax = tx - x, ay = ty - y, az = tz - z;
    displacement = (qx * qx + qy * qy + qz * qz) * turning_.trace() -
                   quadratic (turning_, qx, qy, qz) -
                   2.0f * (qx * twist_.x() + qy * twist_.y() + qz * twist_.z()) +
                   moving_.trace() + along * along * (ax * ax + ay * ay + az * az);
  }

  /** Variance of g . (moved point), with h = g x q. */
  [[gnu::always_inline]] float
  alongGradient (float gx, float gy, float gz, float hx, float hy, float hz) const
  {
    const Eigen::Matrix3f& b = both_;
    return quadratic (turning_, hx, hy, hz) -
           2.0f * (hx * (b (0, 0) * gx + b (0, 1) * gy + b (0, 2) * gz) +
                   hy * (b (1, 0) * gx + b (1, 1) * gy + b (1, 2) * gz) +
                   hz * (b (2, 0) * gx + b (2, 1) * gy + b (2, 2) * gz)) +
           quadratic (moving_, gx, gy, gz);
  }

  Eigen::Matrix3f rotation_;
  Eigen::Vector3f centroid_, turned_centroid_, translation_;
  Eigen::Matrix3f turning_, both_, moving_; ///< blocks of the covariance, turned
  Eigen::Vector3f twist_;                   ///< with q . twist = trace ([q]x both)
  float fx_, fy_;
  float noise_;
};

/** Where motions differ within a radius: 255 in CV_8UC1. Inside of a rigid body they
 * hardly do. */
cv::Mat
nearOtherMotions (const SceneFlow& scene, int radius, int threads)
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
  parallelFor (threads, motion.rows, 32, [&] (int y) {
    for (int x = 0; x < motion.cols; ++x) {
      const int label = scene.labels.at<int> (y, x);
      motion.at<float> (y, x) = label < 0 ? -1.0f : motion_of[label];
    }
  });
  cv::Mat lowest, highest;
  const cv::Mat window = cv::Mat::ones (2 * radius + 1, 2 * radius + 1, CV_8UC1);
  inThisThread ([&] {
    cv::erode (motion, lowest, window);
    cv::dilate (motion, highest, window);
  });
  return lowest != highest;
}

/** Mean squared difference of the motion from those around a pixel: two rings of eight.
 */
Variance
differenceAround (const SceneFlow& scene,
                  const cv::Point& at,
                  const DeviationTuning& tuning)
{
  const int radii[]{tuning.near_step, tuning.far_step};
  const cv::Vec2f flow = scene.flow.at<cv::Vec2f> (at);
  const cv::Vec3f displacement = scene.displacement.at<cv::Vec3f> (at);
  const cv::Rect image ({}, scene.flow.size());
  Variance sum;
  float weights = 0.0f;
  for (int ring = 0; ring < 2; ++ring)
    for (int i = 0; i < 9; ++i) {
      const cv::Point other = at + radii[ring] * cv::Point (i % 3 - 1, i / 3 - 1);
      if (i == 4 || !image.contains (other))
        continue;
      const cv::Vec2f f = scene.flow.at<cv::Vec2f> (other) - flow;
      const float d = f.dot (f);
      if (!std::isfinite (d))
        continue;
      const float weight = ring == 0 ? 1.0f : tuning.far_weight;
      sum.flow += weight * d;
      const cv::Vec3f way = scene.displacement.at<cv::Vec3f> (other) - displacement;
      sum.displacement += weight * way.dot (way);
      weights += weight;
    }
  if (weights > 0.0f)
    return {sum.flow / weights, sum.displacement / weights};
  return {};
}

/** Writes deviations where there is a motion. */
class DeviationWriter {
public:
  DeviationWriter (const PinholeCamera& camera,
                   const DeviationTuning& tuning,
                   int threads,
                   SceneFlow& result)
  : tuning_ (tuning)
  , least_ (static_cast<float> (tuning.least_pixels))
  , pixel_ (static_cast<float> (tuning.least_pixels / camera.fx))
  , near_others_ (nearOtherMotions (result, tuning.far_step, threads))
  , result_ (result)
  {
    result.flow_deviation = unknownImage (result.labels.size(), 1, threads);
    result.displacement_deviation = unknownImage (result.labels.size(), 1, threads);
  }

  /** \param z depth, metres */
  void
  write (int pixel, float z, const Variance& pose)
  {
    if (std::isnan (result_.displacement.ptr<cv::Vec3f>()[pixel][0]))
      return;
    Variance step;
    if (near_others_.ptr()[pixel] != 0) {
      const int width = result_.labels.cols;
      step = differenceAround (result_, {pixel % width, pixel / width}, tuning_);
    }
    const bool seen = result_.visibility.ptr()[pixel] == Visibility::Visible;
    const auto across =
        static_cast<float> (seen ? tuning_.across : tuning_.across_unseen);
    const float side = pixel_ * z;
    result_.displacement_deviation.ptr<float>()[pixel] =
        std::sqrt (pose.displacement + across * step.displacement + side * side);
    if (!std::isnan (result_.flow.ptr<cv::Vec2f>()[pixel][0]))
      result_.flow_deviation.ptr<float>()[pixel] =
          std::sqrt (pose.flow + across * step.flow + least_ * least_);
  }

private:
  const DeviationTuning& tuning_;
  const float least_; ///< pixels
  const float pixel_; ///< the same, metres at a metre's depth
  const cv::Mat near_others_;
  SceneFlow& result_;
};

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
  DeviationWriter writer (camera, tuning, threads, result);
  parallelFor (threads, p.segments(), 8, [&] (int k) {
    const SegmentVariance own (result.segments[k].current_from_reference,
                               covariances[k],
                               p.centroid[k],
                               camera,
                               inverse_depth_noise);
    BlockVariances block;
    for (int first = p.begin[k]; first < p.begin[k + 1]; first += kBlock) {
      const int count = std::min (kBlock, p.begin[k + 1] - first);
      own.carry (p, first, count, block);
      for (int i = 0; i < count; ++i)
        writer.write (
            p.pixel[first + i],
            p.z[first + i],
            {std::max (0.0f, block.flow[i]), std::max (0.0f, block.displacement[i])});
    }
  });
}

} // namespace pcl_msf
