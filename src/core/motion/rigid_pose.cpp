// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <pcl_msf/rigid_pose.h>

#include <cmath>

namespace pcl_msf {

Eigen::Matrix3d
skew (const Eigen::Vector3d& v)
{
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Eigen::Matrix3d
rotationFromVector (const Eigen::Vector3d& a)
{
  // R = I + A [a] + B [a]^2 with A = sin t / t, B = (1 - cos t) / t^2 and their series.
  const double t2 = a.squaredNorm();
  double A = 1.0 - t2 / 6.0;
  double B = 0.5 - t2 / 24.0;
  if (t2 > 1e-8) {
    const double t = std::sqrt (t2);
    A = std::sin (t) / t;
    const double s = std::sin (0.5 * t);
    B = 2.0 * s * s / t2;
  }
  const Eigen::Matrix3d k = skew (a);
  return Eigen::Matrix3d::Identity() + A * k + B * k * k;
}

Eigen::Vector3d
vectorFromRotation (const Eigen::Matrix3d& rotation)
{
  Eigen::Quaterniond q (rotation);
  q.normalize();
  if (q.w() < 0.0)
    q.coeffs() = -q.coeffs();
  const double s = q.vec().norm();
  if (s < 1e-12)
    return 2.0 * q.vec();
  return (2.0 * std::atan2 (s, q.w()) / s) * q.vec();
}

Eigen::Matrix3d
leftJacobian (const Eigen::Vector3d& a)
{
  // J = I + B [a] + C [a]^2, C = (t - sin t) / t^3.
  const double t2 = a.squaredNorm();
  double B = 0.5 - t2 / 24.0;
  double C = 1.0 / 6.0 - t2 / 120.0;
  if (t2 > 1e-6) {
    const double t = std::sqrt (t2);
    const double s = std::sin (0.5 * t);
    B = 2.0 * s * s / t2;
    C = (t - std::sin (t)) / (t2 * t);
  }
  const Eigen::Matrix3d k = skew (a);
  return Eigen::Matrix3d::Identity() + B * k + C * k * k;
}

RigidPose
RigidPose::fromMatrix (const Eigen::Matrix3d& rotation,
                       const Eigen::Vector3d& translation)
{
  const Eigen::Vector3d a = vectorFromRotation (rotation);
  RigidPose pose;
  pose.parameters = {
      a.x(), a.y(), a.z(), translation.x(), translation.y(), translation.z()};
  return pose;
}

RigidPose
RigidPose::fromNearestRotation (const Eigen::Matrix3d& m,
                                const Eigen::Vector3d& translation)
{
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd (
      m, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU();
  if ((u * svd.matrixV().transpose()).determinant() < 0.0)
    u.col (2) = -u.col (2);
  return fromMatrix (Eigen::Matrix3d (u * svd.matrixV().transpose()), translation);
}

Eigen::Matrix3d
RigidPose::rotation() const
{
  return rotationFromVector ({parameters[0], parameters[1], parameters[2]});
}

Eigen::Vector3d
RigidPose::operator* (const Eigen::Vector3d& point) const
{
  return rotation() * point + translation();
}

RigidPose
RigidPose::operator* (const RigidPose& b_from_a) const
{
  const Eigen::Matrix3d r = rotation();
  return fromMatrix (Eigen::Matrix3d (r * b_from_a.rotation()),
                     Eigen::Vector3d (r * b_from_a.translation() + translation()));
}

RigidPose
RigidPose::inverse() const
{
  const Eigen::Matrix3d r = rotation().transpose();
  return fromMatrix (r, Eigen::Vector3d (-(r * translation())));
}

double
RigidPose::angle() const
{
  return vectorFromRotation (rotation()).norm();
}

bool
RigidPose::isFinite() const
{
  for (const double p : parameters)
    if (!std::isfinite (p))
      return false;
  return true;
}

} // namespace pcl_msf
