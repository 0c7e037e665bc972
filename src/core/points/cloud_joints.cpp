// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/cloud_joints.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

/** Covariance of the turn and of where `at` is moved to, of a part's pose. */
Matrix6
covarianceAt (const CloudPart& part, const Eigen::Vector3d& at)
{
  Matrix6 information = part.information;
  // Translation and turn have different units: a ridge of each.
  const double turn = 1e-12 * information.topLeftCorner<3, 3>().trace() + 1e-300;
  const double shift = 1e-12 * information.bottomRightCorner<3, 3>().trace() + 1e-300;
  information.diagonal().head<3>().array() += turn;
  information.diagonal().tail<3>().array() += shift;
  const Matrix6 covariance =
      Eigen::LDLT<Matrix6> (information).solve (Matrix6::Identity());
  const Eigen::Matrix3d r = part.target_from_source.rotation();
  const auto& p = part.target_from_source.parameters;
  const Eigen::Matrix3d left = leftJacobian ({p[0], p[1], p[2]});
  Matrix6 change = Matrix6::Identity();
  change.topLeftCorner<3, 3>() = left;
  change.bottomLeftCorner<3, 3>() = -skew (r * at) * left;
  return change * covariance * change.transpose();
}

double
root (double variance)
{
  return std::sqrt (std::max (0.0, variance));
}

} // namespace

CloudJoint
jointBetween (const CloudPart& parent,
              const CloudPart& child,
              const Eigen::Vector3d& seam)
{
  CloudJoint joint;
  const RigidPose turn = parent.target_from_source.inverse() * child.target_from_source;
  const Eigen::Vector3d vector (
      turn.parameters[0], turn.parameters[1], turn.parameters[2]);
  joint.angle = vector.norm();
  joint.axis = joint.angle > 1e-12 ? Eigen::Vector3d (vector / joint.angle)
                                   : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d& a = joint.axis;
  const Eigen::Vector3d moved = turn * seam - seam;
  joint.shift = a.dot (moved);
  // The point of the axis next to the seam: seam + x across the axis with
  // (R - 1) x = -(moved across the axis).
  const Eigen::Vector3d across = moved - joint.shift * a;
  joint.point = seam;
  if (joint.angle > 1e-6)
    joint.point += 0.5 * (across + a.cross (across) / std::tan (0.5 * joint.angle));
  const Matrix6 covariance =
      covarianceAt (parent, joint.point) + covarianceAt (child, joint.point);
  // Turns are in the target's frame; deviations across and along the axis are not
  // changed by the parent's turn but for the axis' direction.
  const Eigen::Vector3d axis = parent.target_from_source.rotation() * a;
  const Eigen::Matrix3d of_turn = covariance.topLeftCorner<3, 3>();
  const Eigen::Matrix3d of_shift = covariance.bottomRightCorner<3, 3>();
  const double along = axis.dot (of_turn * axis);
  joint.angle_deviation = root (along);
  const double lever = 2.0 * std::sin (0.5 * joint.angle);
  const double tilt = root (0.5 * (of_turn.trace() - along));
  joint.axis_deviation = std::min (M_PI / 2.0, lever > 0.0 ? tilt / lever : M_PI / 2.0);
  const double off = root (of_shift.trace() - axis.dot (of_shift * axis));
  joint.point_deviation = lever > 1e-9 ? off / lever : off;
  return joint;
}

} // namespace pcl_msf
