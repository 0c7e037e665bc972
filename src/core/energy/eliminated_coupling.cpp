// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/eliminated_coupling.h"

#include <algorithm>

namespace pcl_msf {

bool
EliminatedCouplingCost::Evaluate (double const* const* parameters,
                                  double* residuals,
                                  double** jacobians) const
{
  const CoupledPose first = first_ ? *first_ : CoupledPose (parameters[0]);
  const CoupledPose second = second_ ? *second_ : CoupledPose (parameters[1]);
  const Vector6 d = poseDifference (first.pose, second.pose, link_, scale_.unit, form_);
  const double gamma = scale_.regularizer * scale_.regularizer;
  const double w = optimalWeight (d.squaredNorm(), gamma, scale_.prior * scale_.prior);
  Eigen::Map<Vector6> weighed (residuals);
  weighed = scale_.regularizer * w * d;
  if (!jacobians)
    return true;
  const Vector6 along = d / std::max (d.norm(), 1e-300);
  using RowMajor = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const auto fill = [&] (const CoupledPose& pose, double sign, double* out) {
    const Matrix6 j = differenceJacobian (pose, link_, scale_.unit, form_);
    const Eigen::Matrix<double, 1, 6> shrink = (1.0 - w) * (along.transpose() * j);
    Eigen::Map<RowMajor> block (out);
    block = sign * scale_.regularizer * w * w * (j - along * shrink);
  };
  if (jacobians[0])
    fill (first, 1.0, jacobians[0]);
  if (jacobians[1])
    fill (second, -1.0, jacobians[1]);
  return true;
}

} // namespace pcl_msf
