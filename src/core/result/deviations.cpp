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
  float flow[kBlock]; ///< NaN behind the camera
  float displacement[kBlock];
};

/** Covariance of a segment's motion, turned and about the segment's centroid, so that
 * floats are enough; matrices row by row. */
struct TurnedCovariance {
  float rotation[9];
  float centroid[3];
  float turned_centroid[3];
  float translation[3];
  float turning[9], both[9], moving[9]; ///< its blocks
  float twist[3];                       ///< with q . twist = trace ([q]x both)
  float turning_trace, moving_trace;
  float fx, fy; ///< pixels
  float noise;  ///< of inverse depth
};

template <int kRows, int kColumns>
void
copy (const Eigen::Matrix<double, kRows, kColumns>& from, float* to)
{
  for (int i = 0; i < kRows; ++i)
    for (int j = 0; j < kColumns; ++j)
      *to++ = static_cast<float> (from (i, j));
}

TurnedCovariance
turnedCovariance (const RigidPose& pose,
                  const Matrix6& covariance,
                  const Eigen::Vector3d& centroid,
                  const PinholeCamera& camera,
                  double inverse_depth_noise)
{
  TurnedCovariance t;
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
  copy<3, 3> (pose.rotation(), t.rotation);
  copy<3, 1> (centroid, t.centroid);
  copy<3, 1> (c, t.turned_centroid);
  copy<3, 1> (pose.translation(), t.translation);
  copy<3, 3> (turning, t.turning);
  copy<3, 3> (both, t.both);
  copy<3, 3> (0.5 * (moving + moving.transpose()), t.moving);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    t.twist[i] = t.both[3 * j + k] - t.both[3 * k + j];
  }
  t.turning_trace = t.turning[0] + (t.turning[4] + t.turning[8]);
  t.moving_trace = t.moving[0] + (t.moving[4] + t.moving[8]);
  t.fx = static_cast<float> (camera.fx);
  t.fy = static_cast<float> (camera.fy);
  t.noise = static_cast<float> (inverse_depth_noise);
  return t;
}

/** x' S x of a symmetric matrix. */
[[gnu::always_inline]] inline float
quadratic (const float (&s)[9], float x, float y, float z)
{
  return x * (s[0] * x + 2.0f * (s[1] * y + s[2] * z)) +
         y * (s[4] * y + 2.0f * s[5] * z) + z * s[8] * z;
}

/** Variance of g . (moved point), with h = g x q. */
[[gnu::always_inline]] inline float
alongGradient (const TurnedCovariance& t,
               float gx,
               float gy,
               float gz,
               float hx,
               float hy,
               float hz)
{
  const float (&b)[9] = t.both;
  return quadratic (t.turning, hx, hy, hz) -
         2.0f * (hx * (b[0] * gx + b[1] * gy + b[2] * gz) +
                 hy * (b[3] * gx + b[4] * gy + b[5] * gz) +
                 hz * (b[6] * gx + b[7] * gy + b[8] * gz)) +
         quadratic (t.moving, gx, gy, gz);
}

/** Carries the covariance to a point: traces of J C J' with J = (-[q]x, 1) as from
 * pointJacobian, by the blocks of C. */
[[gnu::always_inline]] inline void
carryToPoint (const TurnedCovariance& t,
              float x,
              float y,
              float z,
              float& flow,
              float& displacement)
{
  const float (&r)[9] = t.rotation;
  const float ox = x - t.centroid[0], oy = y - t.centroid[1], oz = z - t.centroid[2];
  const float qx = r[0] * ox + r[1] * oy + r[2] * oz;
  const float qy = r[3] * ox + r[4] * oy + r[5] * oz;
  const float qz = r[6] * ox + r[7] * oy + r[8] * oz;
  const float tx = qx + t.turned_centroid[0], ty = qy + t.turned_centroid[1],
              tz = qz + t.turned_centroid[2];
  // Another inverse depth takes the point along its ray.
  const float along = z * t.noise;
  const float mz = tz + t.translation[2];
  const float w = mz > 1e-3f ? 1.0f / mz : std::numeric_limits<float>::quiet_NaN();
  const float a = t.fx * w, c = -a * (tx + t.translation[0]) * w; // d u / d (x, z)
  const float b = t.fy * w, d = -b * (ty + t.translation[1]) * w; // d v / d (y, z)
  const float ahead_u = along * (a * tx + c * tz);
  const float ahead_v = along * (b * ty + d * tz);
  flow = alongGradient (t, a, 0.0f, c, -c * qy, c * qx - a * qz, a * qy) +
         alongGradient (t, 0.0f, b, d, b * qz - d * qy, d * qx, -b * qx) +
         ahead_u * ahead_u + ahead_v * ahead_v;
  const float ax = tx - x, ay = ty - y, az = tz - z;
  displacement = (qx * qx + qy * qy + qz * qz) * t.turning_trace -
                 quadratic (t.turning, qx, qy, qz) -
                 2.0f * (qx * t.twist[0] + qy * t.twist[1] + qz * t.twist[2]) +
                 t.moving_trace + along * along * (ax * ax + ay * ay + az * az);
}

/** Some points of a segment. */
struct PointBlock {
  const TurnedCovariance* covariance;
  const float *x, *y, *z;
  int count; ///< kBlock at the most
  BlockVariances* out;
};

[[gnu::always_inline]] inline void
carryToBlock (const PointBlock& block)
{
#pragma omp simd
  for (int i = 0; i < block.count; ++i)
    carryToPoint (*block.covariance,
                  block.x[i],
                  block.y[i],
                  block.z[i],
                  block.out->flow[i],
                  block.out->displacement[i]);
}

PCL_MSF_VERSIONS (carry, carryToBlock, PointBlock)

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
                SceneFlow& result,
                InstructionSet set)
{
  DeviationWriter writer (camera, tuning, threads, result);
  parallelFor (threads, p.segments(), 8, [&] (int k) {
    const TurnedCovariance own =
        turnedCovariance (result.segments[k].current_from_reference,
                          covariances[k],
                          p.centroid[k],
                          camera,
                          inverse_depth_noise);
    BlockVariances block;
    for (int first = p.begin[k]; first < p.begin[k + 1]; first += kBlock) {
      const int count = std::min (kBlock, p.begin[k + 1] - first);
      carry ({&own, &p.x[first], &p.y[first], &p.z[first], count, &block}, set);
      for (int i = 0; i < count; ++i)
        writer.write (
            p.pixel[first + i],
            p.z[first + i],
            {std::max (0.0f, block.flow[i]), std::max (0.0f, block.displacement[i])});
    }
  });
}

} // namespace pcl_msf
