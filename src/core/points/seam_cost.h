// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/motion/motion_state.h"
#include <ceres/sized_cost_function.h>

#include <vector>

namespace pcl_msf {

/** \brief A segment's motion about its own centre. Steps of the solver are turns about
 * the moved centre and shifts, from zero: far from the origin a turn about the origin
 * is no small step. */
struct CenteredMotion {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d center; ///< before the motion
  Eigen::Vector3d moved;  ///< where the motion takes it

  CenteredMotion (const RigidPose& pose, const Eigen::Vector3d& at)
  : rotation (pose.rotation()), center (at), moved (pose * at)
  {}

  /** \brief With a step: rotation vector, shift. */
  CenteredMotion
  after (const double* step) const;

  RigidPose
  pose () const
  {
    return RigidPose::fromMatrix (rotation, moved - rotation * center);
  }
  Eigen::Vector3d
  operator* (const Eigen::Vector3d& point) const
  {
    return rotation * (point - center) + moved;
  }
};

using SeamDifference = Eigen::Matrix<double, 12, 1>;

/** \brief Difference d (T_j, T_h) of Eq. 10 at a seam: how far the two motions tear it
 * apart, and the difference of the rotations times the lever; in units. */
SeamDifference
seamDifference (const CenteredMotion& first,
                const CenteredMotion& second,
                const SegmentLink& link,
                double unit);

/** \brief The pose regularizer of one link (Eq. 10) over the steps of both segments;
 * its weight has its best value for the state before the step. */
class SeamCost : public ceres::SizedCostFunction<12, 6, 6> {
public:
  /** \param motions of all segments before the step, \param scale sqrt (gamma / links)
   * w^2; both are read when evaluated */
  SeamCost (const std::vector<CenteredMotion>& motions,
            const SegmentLink& link,
            double unit,
            const double& scale)
  : motions_ (motions), link_ (link), unit_ (unit), scale_ (scale)
  {}

  bool
  Evaluate (double const* const* steps,
            double* residuals,
            double** jacobians) const override;

private:
  const std::vector<CenteredMotion>& motions_;
  SegmentLink link_;
  double unit_;
  const double& scale_;
};

} // namespace pcl_msf
