// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/body_blocks.h"
#include "core/multi_frame_energy.h"
#include <ceres/evaluation_callback.h>
#include <ceres/problem.h>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief MultiFrameEnergy as a Ceres problem over a state's poses and weights.
 *
 * Per pair: one compressed block per body, one coupling block per link between bodies,
 * whose weight all pairs share and whose prior only the first pair's block carries. Per
 * non-adjacent pair: one concatenation block per body. The state must outlive the
 * problem and not be resized. */
class MultiFrameProblem : public ceres::EvaluationCallback {
public:
  MultiFrameProblem (MultiFrameEnergy& energy, MultiFrameState& state);

  void
  PrepareForEvaluation (bool evaluate_jacobians, bool new_evaluation_point) override;

  ceres::Problem&
  problem ()
  {
    return *problem_;
  }

  /** \brief The data terms are linearized at the present state: the first evaluation
   * need not sweep again. */
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
  addBodies ();
  void
  addLinks ();
  void
  addConcatenations ();

  MultiFrameEnergy& energy_;
  MultiFrameState& state_;
  std::vector<BodyBlocks> blocks_; ///< per used pair
  std::unique_ptr<ceres::Problem> problem_;
  bool keep_{false};
  bool linearized_{false};
};

} // namespace pcl_msf
