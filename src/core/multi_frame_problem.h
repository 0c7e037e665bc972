// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/multi_frame_energy.h"
#include "core/segment_block.h"
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
  void
  compress (int pair, bool evaluate_jacobians);

  MultiFrameEnergy& energy_;
  MultiFrameState& state_;
  std::vector<std::vector<int>> segments_of_;        ///< per body
  std::vector<std::vector<CompressedBlock>> blocks_; ///< per pair, per body
  std::unique_ptr<ceres::Problem> problem_;
  bool keep_{false};
};

} // namespace pcl_msf
