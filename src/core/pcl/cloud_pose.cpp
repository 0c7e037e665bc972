// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/pcl/cloud_pose.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "core/base/flatten.h"
#include "core/pcl/ray_fit.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_msf {

namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr int kSamplesPerSide = 80; // of the image: 6400 points tell a pose
constexpr double kInFront = 0.9;    // of the points, for an axis to be the forward one
constexpr int kRefits = 20;
constexpr double kExact = 0.01;        // pixels, an error as good as none
constexpr double kSquarePixels = 2.0;  // largest fx / fy, either way
constexpr double kRightAngle = 0.05;   // largest cosine between right and down
constexpr double kOnePoseOnly = 1e-12; // least second eigenvalue, of the largest

struct PixelPoint {
  Eigen::Vector2d pixel;
  Eigen::Vector3d point;
};
using PixelPoints = std::vector<PixelPoint>;
using Projection = Eigen::Matrix<double, 3, 4, Eigen::DontAlign>;
using Square12 = Eigen::Matrix<double, 12, 12, Eigen::DontAlign>;

/** Finite points but the origin, which some drivers write where nothing was measured.
 */
PixelPoints
samplePoints (const cv::Mat& points)
{
  PixelPoints samples;
  const int step_u = std::max (1, points.cols / kSamplesPerSide);
  const int step_v = std::max (1, points.rows / kSamplesPerSide);
  for (int v = 0; v < points.rows; v += step_v)
    for (int u = 0; u < points.cols; u += step_u) {
      const auto& p = points.at<cv::Vec3f> (v, u);
      const Eigen::Vector3d point (p[0], p[1], p[2]);
      if (point.allFinite() && !point.isZero (0.0))
        samples.push_back ({Eigen::Vector2d (u, v), point});
    }
  return samples;
}

CloudPose
noPose ()
{
  return {{}, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), kNone};
}

double
medianError (const PixelPoints& samples, const CloudPose& pose)
{
  std::vector<double> errors;
  for (const PixelPoint& s : samples) {
    const Eigen::Vector3d p = pose.optical_from_cloud * s.point + pose.offset;
    errors.push_back (p.z() > 0.0 ? (pose.camera.project (p) - s.pixel).norm() : kNone);
  }
  return errors.empty() ? kNone : medianOf (std::move (errors));
}

/** Fits the lines with cloud axis `forward` ahead and `right` across. */
CloudPose
fitAxes (const PixelPoints& samples, cv::Size size, int forward, int right)
{
  const int down = 3 - forward - right;
  std::size_t positive = 0;
  for (const PixelPoint& s : samples)
    positive += s.point[forward] > 0.0;
  const double ahead = 2 * positive >= samples.size() ? 1.0 : -1.0;
  std::vector<RaySample> x;
  std::vector<RaySample> y;
  for (const PixelPoint& s : samples)
    if (const double z = ahead * s.point[forward]; z > 0.0) {
      x.push_back ({s.pixel.x(), s.point[right] / z});
      y.push_back ({s.pixel.y(), s.point[down] / z});
    }
  CloudPose pose = noPose();
  if (x.size() < kInFront * samples.size())
    return pose;
  const RayLine u = robustLine (std::move (x));
  const RayLine v = robustLine (std::move (y));
  pose.camera = {std::abs (u.focal), std::abs (v.focal), u.center, v.center};
  if (!pose.camera.isValid (size.width, size.height))
    return pose;
  pose.optical_from_cloud.setZero();
  pose.optical_from_cloud (0, right) = u.focal > 0.0 ? 1.0 : -1.0;
  pose.optical_from_cloud (1, down) = v.focal > 0.0 ? 1.0 : -1.0;
  pose.optical_from_cloud (2, forward) = ahead;
  pose.error = medianError (samples, pose);
  return pose;
}

/** Shifts and scales values to mean 0 and mean square 1 in each dimension. */
template <int N>
struct Normalization {
  Eigen::Matrix<double, N, 1> mean = Eigen::Matrix<double, N, 1>::Zero();
  double scale{1.0};

  template <typename Get>
  Normalization (const PixelPoints& samples, Get get)
  {
    for (const PixelPoint& s : samples)
      mean += get (s) / static_cast<double> (samples.size());
    double square = 0.0;
    for (const PixelPoint& s : samples)
      square += (get (s) - mean).squaredNorm() / (N * double (samples.size()));
    if (square > 0.0)
      scale = 1.0 / std::sqrt (square);
  }
  Eigen::Matrix<double, N + 1, N + 1>
  matrix () const
  {
    Eigen::Matrix<double, N + 1, N + 1> m;
    m.setIdentity();
    m.template topLeftCorner<N, N>() *= scale;
    m.template topRightCorner<N, 1>() = -scale * mean;
    return m;
  }
};

/** The 3x4 matrix that takes points to pixels, by weighted linear least squares; zero
 * when the points leave it open. pcl::estimateProjectionMatrix sums unscaled floats,
 * which loses the offset of a cloud far from the origin. */
PCL_MSF_FLATTEN Projection // none of Eigen's functions for aligned types is left
                           // shared
fitProjection (const PixelPoints& samples, const std::vector<double>& weights)
{
  const Normalization<2> flat (samples, [] (const PixelPoint& s) { return s.pixel; });
  const Normalization<3> space (samples, [] (const PixelPoint& s) { return s.point; });
  Square12 sum = Square12::Zero();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const PixelPoint& s = samples[i];
    const Eigen::Vector2d uv = flat.scale * (s.pixel - flat.mean);
    Eigen::Vector4d p;
    p << space.scale * (s.point - space.mean), 1.0;
    Eigen::Matrix<double, 12, 2> rows = Eigen::Matrix<double, 12, 2>::Zero();
    rows.col (0) << p, Eigen::Vector4d::Zero(), -uv.x() * p;
    rows.col (1) << Eigen::Vector4d::Zero(), p, -uv.y() * p;
    sum += weights[i] * (rows * rows.transpose());
  }
  cv::Mat values; // descending
  cv::Mat vectors;
  cv::eigen (cv::Mat (12, 12, CV_64FC1, sum.data()), values, vectors);
  if (!(values.at<double> (10) > kOnePoseOnly * values.at<double> (0)))
    return Projection::Zero();
  Projection normalized;
  for (int i = 0; i < 12; ++i)
    normalized (i / 4, i % 4) = vectors.at<double> (11, i);
  return flat.matrix().inverse() * normalized * space.matrix();
}

/** Camera, rotation and offset of a projection; no pose when its pixels are not square
 * and upright, which a wrong fit's are not. */
CloudPose
decompose (Projection projection, const PixelPoints& samples, cv::Size size)
{
  CloudPose pose = noPose();
  projection /= projection.block<1, 3> (2, 0).norm();
  std::size_t behind = 0;
  for (const PixelPoint& s : samples)
    behind += projection.row (2) * s.point.homogeneous() < 0.0;
  if (2 * behind > samples.size())
    projection = -projection;
  const Eigen::Matrix3d m = projection.leftCols<3>();
  const Eigen::RowVector3d forward = m.row (2);
  pose.camera.cx = m.row (0).dot (forward);
  pose.camera.cy = m.row (1).dot (forward);
  const Eigen::RowVector3d right = m.row (0) - pose.camera.cx * forward;
  const Eigen::RowVector3d down = m.row (1) - pose.camera.cy * forward;
  pose.camera.fx = right.norm();
  pose.camera.fy = down.norm();
  const double aspect = pose.camera.fx / pose.camera.fy;
  if (!pose.camera.isValid (size.width, size.height) || aspect > kSquarePixels ||
      aspect < 1.0 / kSquarePixels ||
      std::abs (right.normalized().dot (down.normalized())) > kRightAngle)
    return pose;
  pose.optical_from_cloud << right.normalized(), down.normalized(), forward;
  const Eigen::Vector3d last = projection.col (3);
  pose.offset << (last.x() - pose.camera.cx * last.z()) / pose.camera.fx,
      (last.y() - pose.camera.cy * last.z()) / pose.camera.fy, last.z();
  pose.error = medianError (samples, pose);
  return pose;
}

/** Weights of the least absolute error: wild points have little, and a plane that
 * holds most of the points does not outvote the others, as trimming lets it. */
std::vector<double>
absoluteWeights (const PixelPoints& samples, const Projection& projection)
{
  std::vector<double> weights;
  for (const PixelPoint& s : samples) {
    const Eigen::Vector3d p = projection * s.point.homogeneous();
    const double error = (p.hnormalized() - s.pixel).norm();
    weights.push_back (error < kNone ? 1.0 / (error + kExact) : 0.0);
  }
  return weights;
}

} // namespace

CloudPose
poseByAxes (const cv::Mat& points)
{
  const PixelPoints samples = samplePoints (points);
  CloudPose best = noPose();
  for (int forward = 0; forward < 3; ++forward)
    for (int right = 0; right < 3; ++right) {
      if (right == forward)
        continue;
      const CloudPose pose = fitAxes (samples, points.size(), forward, right);
      if (pose.error < best.error)
        best = pose;
    }
  return best;
}

CloudPose
poseByProjection (const cv::Mat& points)
{
  const PixelPoints samples = samplePoints (points);
  std::vector<double> weights (samples.size(), 1.0);
  Projection projection = Projection::Zero();
  for (int i = 0; i < kRefits; ++i) {
    projection = fitProjection (samples, weights);
    if (projection.isZero (0.0) || !projection.allFinite())
      return noPose();
    weights = absoluteWeights (samples, projection);
  }
  return decompose (projection, samples, points.size());
}

} // namespace pcl_msf
