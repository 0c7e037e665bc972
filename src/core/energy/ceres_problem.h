// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/body_blocks.h"
#include "core/energy/energy.h"
#include <ceres/evaluation_callback.h>
#include <ceres/problem.h>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief The energy as a Ceres problem over a state's poses and weights.
 *
 * Per pair one compressed block per body, filled by one parallel sweep before each
 * evaluation, and what Energy::addTo adds. The state must outlive the problem and not
 * be resized. */
class CeresProblem : public ceres::EvaluationCallback {
public:
  CeresProblem (Energy& energy, WindowState& state);

  void
  PrepareForEvaluation (bool evaluate_jacobians, bool new_evaluation_point) override;

  ceres::Problem&
  problem ()
  {
    return *problem_;
  }

  /** \brief The data terms are linearized at the present state: the next evaluation
   * need not sweep. */
  void
  startsLinearized ()
  {
    linearized_ = true;
  }

  /** \brief Damps the bodies. \param reach per used pair; must outlive the problem */
  void
  setReach (const std::vector<StepReach>* reach)
  {
    reach_ = reach;
  }

  /** \brief The poses of the last evaluation: where a step led that Ceres may have
   * refused. */
  const std::vector<std::vector<RigidPose>>&
  tried () const
  {
    return tried_;
  }

protected:
  /** \brief Fills the blocks from the data terms' last sweep, and unpacks the state's
   * poses for the couplings. */
  void
  fill (bool with_jacobians);

private:
  void
  unpackPoses ();

  Energy& energy_;
  WindowState& state_;
  std::vector<BodyBlocks> blocks_; ///< per used pair
  CoupledPoses poses_;             ///< of the state
  const std::vector<StepReach>* reach_{nullptr};
  std::vector<std::vector<RigidPose>> tried_;
  std::unique_ptr<ceres::Problem> problem_;
  bool linearized_{false};
};

} // namespace pcl_msf
