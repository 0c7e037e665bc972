// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/body_blocks.h"
#include "core/joint_solver.h"
#include <ceres/evaluation_callback.h>
#include <ceres/problem.h>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief JointEnergy as a Ceres problem over a state's poses and weights.
 *
 * One compressed block per body, filled by one parallel sweep before each evaluation;
 * one block per link between different bodies. Links inside a body cost nothing. The
 * state must outlive the problem and not be resized.
 */
class JointProblem : public ceres::EvaluationCallback {
public:
  JointProblem (JointEnergy& energy, MotionState& state);

  void
  PrepareForEvaluation (bool evaluate_jacobians, bool new_evaluation_point) override;

  ceres::Problem&
  problem ()
  {
    return *problem_;
  }

  /** \brief The data term is linearized at the present state: the first evaluation need
   * not sweep again. */
  void
  startsLinearized ()
  {
    linearized_ = true;
  }

  /** \brief Keep the correspondences of the last linearization (tests). */
  void
  keepCorrespondences (bool keep)
  {
    keep_ = keep;
  }

private:
  void
  addLinks ();

  JointEnergy& energy_;
  MotionState& state_;
  BodyBlocks blocks_;
  std::unique_ptr<ceres::Problem> problem_;
  bool keep_{false};
  bool linearized_{false};
};

} // namespace pcl_msf
