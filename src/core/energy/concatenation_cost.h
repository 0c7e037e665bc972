// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <ceres/cost_function.h>
#include <pcl_msf/rigid_pose.h>

#include <vector>

namespace pcl_msf {

/** \brief Where a body's points are, as far as its mean displacement needs them. */
struct BodyShape {
  Eigen::Vector3d center{Eigen::Vector3d::Zero()}; ///< metres
  Eigen::Matrix3d spread{Eigen::Matrix3d::Zero()}; ///< L with L L' = covariance, metres
};

/** \brief Pose concatenation of one body (Eq. 14): a pair's own pose against the
 * product of the steps between its frames.
 *
 * Measured, like the regularizer, as a displacement: the mean over the body's points of
 * the squared distance between where the two put a point is |d center|^2 + |d spread|^2
 * exactly, with d the difference of the two motions. Twelve residuals: the displacement
 * of the centre and of the three columns of the spread. Parameters: the pair's pose,
 * then the steps' in order.
 */
class ConcatenationCost : public ceres::CostFunction {
public:
  /** \param inverse per step: walked backwards
   * \param scale per metre: root of the weight times pixels per metre */
  ConcatenationCost (const BodyShape& shape,
                     const std::vector<bool>& inverse,
                     double scale);

  bool
  Evaluate (double const* const* parameters,
            double* residuals,
            double** jacobians) const override;

private:
  BodyShape shape_;
  std::vector<bool> inverse_;
  double scale_;
};

/** \brief The poses of steps multiplied in order. */
RigidPose
concatenate (const std::vector<RigidPose>& steps, const std::vector<bool>& inverse);

} // namespace pcl_msf
