// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/seam_cost.h"

#include <cmath>

namespace pcl_msf {

CenteredMotion
CenteredMotion::after (const double* step) const
{
  CenteredMotion next = *this;
  next.rotation = rotationFromVector ({step[0], step[1], step[2]}) * rotation;
  next.moved += Eigen::Vector3d (step[3], step[4], step[5]);
  return next;
}

SeamDifference
seamDifference (const CenteredMotion& first,
                const CenteredMotion& second,
                const SegmentLink& link,
                double unit)
{
  SeamDifference d;
  d.head<3>() = (first * link.midpoint - second * link.midpoint) / unit;
  const double lever = link.lever / (unit * std::sqrt (2.0));
  for (int c = 0; c < 3; ++c)
    d.segment<3> (3 + 3 * c) = lever * (first.rotation.col (c) - second.rotation.col (c));
  return d;
}

bool
SeamCost::Evaluate (double const* const* steps,
                    double* residuals,
                    double** jacobians) const
{
  const CenteredMotion motions[2] = {motions_[link_.first].after (steps[0]),
                                     motions_[link_.second].after (steps[1])};
  Eigen::Map<SeamDifference> d (residuals);
  d = scale_ * seamDifference (motions[0], motions[1], link_, unit_);
  if (!jacobians)
    return true;
  const double lever = link_.lever / (unit_ * std::sqrt (2.0));
  for (int s = 0; s < 2; ++s) {
    if (!jacobians[s])
      continue;
    Eigen::Map<Eigen::Matrix<double, 12, 6, Eigen::RowMajor>> j (jacobians[s]);
    j.setZero();
    const double sign = s == 0 ? scale_ : -scale_;
    const Eigen::Matrix3d turn =
        leftJacobian ({steps[s][0], steps[s][1], steps[s][2]});
    const Eigen::Vector3d arm = motions[s] * link_.midpoint - motions[s].moved;
    j.block<3, 3> (0, 0) = -sign / unit_ * skew (arm) * turn;
    j.block<3, 3> (0, 3).diagonal().setConstant (sign / unit_);
    for (int c = 0; c < 3; ++c)
      j.block<3, 3> (3 + 3 * c, 0) =
          -sign * lever * skew (motions[s].rotation.col (c)) * turn;
  }
  return true;
}

} // namespace pcl_msf
