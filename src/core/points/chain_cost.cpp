// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/chain_cost.h"

namespace pcl_msf {

namespace {

using RowMajor = Eigen::Matrix<double, 12, 6, Eigen::RowMajor>;

/** d residuals / d step of one motion.
 * \param arms from the moved centre of the motion to where it takes the segment's
 * centre, and its spreads as it turns them \param rest what turns them further, scaled
 */
void
fillJacobian (const Eigen::Vector3d& arm,
              const Eigen::Matrix3d& spreads,
              const Eigen::Matrix3d& rest,
              const double* step,
              double* out)
{
  Eigen::Map<RowMajor> j (out);
  j.setZero();
  const Eigen::Matrix3d turn = leftJacobian ({step[0], step[1], step[2]});
  j.block<3, 3> (0, 0) = -rest * skew (arm) * turn;
  j.block<3, 3> (0, 3) = rest;
  for (int c = 0; c < 3; ++c)
    j.block<3, 3> (3 + 3 * c, 0) = -rest * skew (spreads.col (c)) * turn;
}

} // namespace

bool
ChainCost::Evaluate (double const* const* steps,
                     double* residuals,
                     double** jacobians) const
{
  const CenteredMotion direct = direct_.after (steps[0]);
  const CenteredMotion first = first_.after (steps[1]);
  const CenteredMotion second = second_.after (steps[2]);
  const Eigen::Vector3d there = direct * shape_.center;
  const Eigen::Vector3d between = first * shape_.center;
  const Eigen::Vector3d chained = second * between;
  const Eigen::Matrix3d spread = direct.rotation * shape_.spread;
  const Eigen::Matrix3d spread_between = first.rotation * shape_.spread;
  const Eigen::Matrix3d spread_chained = second.rotation * spread_between;
  Eigen::Map<SeamDifference> r (residuals);
  r.head<3>() = scale_ * (there - chained);
  for (int c = 0; c < 3; ++c)
    r.segment<3> (3 + 3 * c) = scale_ * (spread.col (c) - spread_chained.col (c));
  if (!jacobians)
    return true;
  const Eigen::Matrix3d same = scale_ * Eigen::Matrix3d::Identity();
  if (jacobians[0])
    fillJacobian (there - direct.moved, spread, same, steps[0], jacobians[0]);
  if (jacobians[1])
    fillJacobian (between - first.moved,
                  spread_between,
                  -scale_ * second.rotation,
                  steps[1],
                  jacobians[1]);
  if (jacobians[2])
    fillJacobian (
        chained - second.moved, spread_chained, -same, steps[2], jacobians[2]);
  return true;
}

} // namespace pcl_msf
