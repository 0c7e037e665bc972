// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/rigid_moments.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace pcl_msf {

namespace {

using Vector12 = Eigen::Matrix<double, 12, 1, Eigen::DontAlign>;

constexpr int kSteps = 6;
constexpr double kDamping = 1e-9; // of the quadratic's trace
constexpr double kMoreDamping = 1e3;
constexpr double kRounding = 1e-12; // of the sum that the cost is the rest of
constexpr double kSettled = 1e-9;   // step, radians and units

Vector12
numbersOf (const Eigen::Matrix3d& r, const Eigen::Vector3d& t)
{
  Vector12 z;
  for (int k = 0; k < 3; ++k)
    z.segment<3> (3 * k) = r.col (k);
  z.tail<3>() = t;
  return z;
}

/** d z / d (turn about the origin of the target's frame, shift). */
Eigen::Matrix<double, 12, 6>
derivative (const Vector12& z)
{
  Eigen::Matrix<double, 12, 6> d = Eigen::Matrix<double, 12, 6>::Zero();
  for (int k = 0; k < 4; ++k)
    d.block<3, 3> (3 * k, 0) = -skew (z.segment<3> (3 * k));
  d.bottomRightCorner<3, 3>().setIdentity();
  return d;
}

} // namespace

void
RigidMoments::add (const Eigen::Vector3d& point, const PointPull& pull, double weight)
{
  const Eigen::Vector4d p (point.x(), point.y(), point.z(), 1.0);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      h_.block<3, 3> (3 * i, 3 * j) += weight * p[i] * p[j] * pull.a;
    v_.segment<3> (3 * i) += weight * p[i] * pull.b;
  }
  c_ += weight * pull.c;
  weight_ += weight * pull.weight;
}

void
RigidMoments::add (const RigidMoments& other)
{
  h_ += other.h_;
  v_ += other.v_;
  c_ += other.c_;
  weight_ += other.weight_;
}

double
RigidMoments::cost (const RigidPose& pose) const
{
  return std::max (0.0, valueAt (numbersOf (pose.rotation(), pose.translation())));
}

double
RigidMoments::valueAt (const Numbers& z) const
{
  return 0.5 * z.dot (h_ * z) - v_.dot (z) + c_;
}

/** Over the turn about the origin of the target's frame and the shift. */
Matrix6
RigidMoments::quadratic (const Numbers& z) const
{
  const Eigen::Matrix<double, 12, 6> d = derivative (z);
  return d.transpose() * h_ * d;
}

RigidPose
RigidMoments::solve (const RigidPose& start, Matrix6* information) const
{
  Eigen::Matrix3d r = start.rotation();
  Eigen::Vector3d t = start.translation();
  Vector12 z = numbersOf (r, t);
  Matrix6 a = quadratic (z);
  double reached = valueAt (z);
  double damping = kDamping;
  for (int step = 0; step < kSteps; ++step) {
    const Vector6 g = derivative (z).transpose() * (h_ * z - v_);
    Matrix6 damped = a;
    damped.diagonal().array() += damping * a.trace() + 1e-15;
    const Vector6 x = -Eigen::LDLT<Matrix6> (damped).solve (g);
    const Eigen::Matrix3d turn = rotationFromVector (x.head<3>());
    const Eigen::Matrix3d next_r = turn * r;
    const Eigen::Vector3d next_t = turn * t + x.tail<3>();
    const Vector12 next = numbersOf (next_r, next_t);
    const double now = valueAt (next);
    // Few pulls leave turns free that a step of Newton's would be lost in.
    if (!(now <= reached + kRounding * std::abs (c_))) {
      damping *= kMoreDamping;
      continue;
    }
    r = next_r;
    t = next_t;
    z = next;
    a = quadratic (z);
    reached = now;
    if (x.norm() < kSettled)
      break;
  }
  const RigidPose pose = RigidPose::fromMatrix (r, t);
  if (information) {
    Matrix6 change = Matrix6::Identity();
    change.topLeftCorner<3, 3>() =
        leftJacobian ({pose.parameters[0], pose.parameters[1], pose.parameters[2]});
    // A turn about the origin moves the translation, too.
    change.bottomLeftCorner<3, 3>() = skew (t) * change.topLeftCorner<3, 3>();
    *information = change.transpose() * a * change;
  }
  return pose;
}

} // namespace pcl_msf
