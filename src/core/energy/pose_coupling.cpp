// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/pose_coupling.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

CoupledPose
poseFrom (const double* parameters)
{
  RigidPose pose;
  std::copy (parameters, parameters + 6, pose.parameters.begin());
  return CoupledPose (pose);
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

CoupledPose::CoupledPose (const RigidPose& from)
: pose (from), left_jacobian (leftJacobian (pose.rotation_vector))
{}

void
PoseCouplingCost::poseJacobian (const CoupledPose& pose,
                                double sign,
                                double weight,
                                double* out) const
{
  using RowMajor = Eigen::Matrix<double, 7, 6, Eigen::RowMajor>;
  Eigen::Map<RowMajor> j (out);
  j.setZero();
  const double g = sign * scale_.regularizer * weight * weight;
  if (form_ == PoseDifference::Parameters) {
    j.topRows<6>().diagonal().setConstant (g);
    return;
  }
  const double s = g * scale_.unit;
  j.block<3, 3> (0, 0) =
      -s * skew (pose.pose.rotation * link_.midpoint) * pose.left_jacobian;
  j.block<3, 3> (0, 3).diagonal().setConstant (s);
  j.block<3, 3> (3, 0).diagonal().setConstant (s * link_.lever);
}

bool
PoseCouplingCost::Evaluate (double const* const* parameters,
                            double* residuals,
                            double** jacobians) const
{
  const double w = parameters[2][0];
  const CoupledPose first = first_ ? *first_ : poseFrom (parameters[0]);
  const CoupledPose second = second_ ? *second_ : poseFrom (parameters[1]);
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
