// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/segment_block.h"
#include "core/energy/step_reach.h"
#include <ceres/problem.h>

#include <vector>

namespace pcl_msf {

/** \brief One pair's data terms as a compressed block per body, which the evaluation
 * callback fills. Must outlive the problem that it was added to. */
class BodyBlocks {
public:
  /** \param moving per body: may it move? Only those have blocks; empty: all */
  BodyBlocks (const std::vector<int>& body_of,
              std::size_t bodies,
              const std::vector<char>& moving);

  /** \brief Adds a residual block per body that may move. \param poses per body: the
   * unknowns */
  void
  addTo (ceres::Problem& problem, std::vector<RigidPose>& poses) const;

  /** \brief Sums the bodies' segments up after a sweep. \param poses per body, of the
   * sweep \param reach damps the bodies; nullptr = undamped */
  void
  fill (const DataTerm& data,
        const std::vector<RigidPose>& poses,
        const StepReach* reach,
        bool with_jacobians);

private:
  std::vector<int> moving_;                   ///< bodies
  std::vector<std::vector<int>> segments_of_; ///< per body
  std::vector<CompressedBlock> blocks_;       ///< per body
};

} // namespace pcl_msf
