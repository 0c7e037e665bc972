// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/pose_coupling.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

RigidPose
poseFrom (const double* parameters)
{
  RigidPose pose;
  std::copy (parameters, parameters + 6, pose.parameters.begin());
  return pose;
}

} // namespace

Vector6
poseDifference (const UnpackedPose& first,
                const UnpackedPose& second,
                const SegmentLink& link,
                double unit,
                PoseDifference form)
{
  Vector6 d;
  const Eigen::Vector3d turn = first.rotation_vector - second.rotation_vector;
  const Eigen::Vector3d shift = first.translation - second.translation;
  if (form == PoseDifference::Parameters) {
    d.head<3>() = turn;
    d.tail<3>() = shift;
    return d;
  }
  d.head<3>() = unit * ((first.rotation - second.rotation) * link.midpoint + shift);
  d.tail<3>() = unit * link.lever * turn;
  return d;
}

Matrix6
differenceJacobian (const CoupledPose& pose,
                    const SegmentLink& link,
                    double unit,
                    PoseDifference form)
{
  if (form == PoseDifference::Parameters)
    return Matrix6::Identity();
  Matrix6 j = Matrix6::Zero();
  j.topLeftCorner<3, 3>() =
      -unit * skew (pose.pose.rotation * link.midpoint) * pose.left_jacobian;
  j.topRightCorner<3, 3>().diagonal().setConstant (unit);
  j.bottomLeftCorner<3, 3>().diagonal().setConstant (unit * link.lever);
  return j;
}

CoupledPose::CoupledPose (const RigidPose& from)
: pose (from), left_jacobian (leftJacobian (pose.rotation_vector))
{}

CoupledPose::CoupledPose (const double* parameters)
: CoupledPose (poseFrom (parameters))
{}

void
PoseCouplingCost::poseJacobian (const CoupledPose& pose,
                                double sign,
                                double weight,
                                double* out) const
{
  using RowMajor = Eigen::Matrix<double, 7, 6, Eigen::RowMajor>;
  Eigen::Map<RowMajor> j (out);
  j.topRows<6>() = sign * scale_.regularizer * weight * weight *
                   differenceJacobian (pose, link_, scale_.unit, form_);
  j.row (6).setZero();
}

bool
PoseCouplingCost::Evaluate (double const* const* parameters,
                            double* residuals,
                            double** jacobians) const
{
  const double w = parameters[2][0];
  const CoupledPose first = first_ ? *first_ : CoupledPose (parameters[0]);
  const CoupledPose second = second_ ? *second_ : CoupledPose (parameters[1]);
  const Vector6 d = poseDifference (first.pose, second.pose, link_, scale_.unit, form_);
  Eigen::Map<Vector6> head (residuals);
  head = scale_.regularizer * w * w * d;
  residuals[6] = scale_.prior * (1.0 - w * w);
  if (!jacobians)
    return true;
  if (jacobians[0])
    poseJacobian (first, 1.0, w, jacobians[0]);
  if (jacobians[1])
    poseJacobian (second, -1.0, w, jacobians[1]);
  if (jacobians[2]) {
    Eigen::Map<Vector6> j (jacobians[2]);
    j = 2.0 * scale_.regularizer * w * d;
    jacobians[2][6] = -2.0 * scale_.prior * w;
  }
  return true;
}

double
optimalWeight (double squared_difference, double gamma, double eta)
{
  return std::sqrt (eta / (eta + gamma * squared_difference));
}

} // namespace pcl_msf
