// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/solve_tuning.h"
#include "core/energy/body_shapes.h"
#include <pcl_msf/rigid_pose.h>

#include <vector>

namespace pcl_msf {

/** \brief How far each body's linearization is trusted: pixels that its points move in
 * one step, root mean square. A body that would go farther is damped as much as that
 * needs (Moré, The Levenberg-Marquardt algorithm: implementation and theory, 1978, with
 * the points' motion as the measure), whatever the others do. */
class StepReach {
public:
  /** \param shapes per body, in the frame that the points come from
   * \param focal_length of the level, pixels */
  StepReach (std::vector<BodyShape> shapes,
             double focal_length,
             const StepTuning& tuning);

  /** \brief Adds to a body's information what keeps the step -inv (A) b in reach.
   * \param pose where it is linearized */
  void
  damp (int body,
        const RigidPose& pose,
        const Vector6& gradient,
        Matrix6& information) const;

  /** \brief The last step lowered the energy of a body, or did not. */
  void
  learn (int body, bool gained);

private:
  Matrix6
  squaredMotion (int body, const RigidPose& pose) const;

  std::vector<BodyShape> shapes_;
  double focal_length_;
  const StepTuning& tuning_;
  std::vector<double> pixels_; ///< per body
};

} // namespace pcl_msf
