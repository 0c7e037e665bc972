// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/concatenation_cost.h"
#include "core/energy_solve.h"
#include "core/multi_frame_level.h"
#include "core/pose_coupling.h"
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/parameters.h>
#include <pcl_msf/scene_flow.h>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief Numbers of residuals of each kind: Eq. 15. */
struct ResidualCounts {
  int brightness{0};    ///< n_C, over all pairs
  int icp{0};           ///< n_D, over all pairs
  int regularizer{0};   ///< links times pairs
  int prior{0};         ///< links, once
  int concatenation{0}; ///< segments times non-adjacent pairs
  int
  total () const
  {
    return brightness + icp + regularizer + prior + concatenation;
  }
};

/** \brief The energy of Eq. 13 on one level: data terms and coupling of every pair,
 * weights and their prior shared, and the concatenation of non-adjacent pairs. */
class MultiFrameEnergy {
public:
  MultiFrameEnergy (MultiFrameLevel& level,
                    const MultiFrameScene& scene,
                    const EnergyParameters& energy,
                    double concatenation_weight,
                    const MultiFrameState& state);

  SolveOutcome
  minimize (const SolverParameters& solver,
            SolveMonitor& monitor,
            MultiFrameState& state);

  /** \brief The energy by term; linearizes the data terms at the state. */
  EnergyCost
  evaluate (const MultiFrameState& state);

  /** \brief As evaluate, with the data terms of the last sweep. */
  EnergyCost
  presentCost (const MultiFrameState& state) const;

  /** \brief Sets every weight to its optimum for the poses of all pairs. */
  void
  relaxWeights (MultiFrameState& state) const;

  ResidualCounts
  countResiduals () const;

  MultiFrameLevel&
  level ()
  {
    return level_;
  }

private:
  friend class MultiFrameProblem;

  double
  unit (double depth) const;
  double
  priorWeight () const;
  CouplingScale
  couplingScale (const SegmentLink& link, bool with_prior) const;
  double
  concatenationScale (int segments, double depth) const;
  void
  carryShapes (const MultiFrameState& state);
  /** Calls visit (cost, body, pair, steps) for every body and non-adjacent pair. */
  template <typename Visitor>
  void
  forEachConcatenation (const MultiFrameState& state, const Visitor& visit) const;
  double
  concatenationCost (const MultiFrameState& state) const;
  double
  squaredDifferences (int link, const MultiFrameState& state) const;

  MultiFrameLevel& level_;
  const MultiFrameScene& scene_;
  const EnergyParameters& energy_;
  double concatenation_weight_;
  std::vector<std::vector<SegmentLink>> links_; ///< per frame, carried there
  std::vector<int> segments_of_body_;           ///< how many
  std::vector<std::vector<BodyShape>> shapes_;  ///< per frame, per body
};

template <typename Visitor>
void
MultiFrameEnergy::forEachConcatenation (const MultiFrameState& state,
                                        const Visitor& visit) const
{
  for (const int p : scene_.used) {
    if (scene_.pairs[p].adjacent)
      continue;
    const std::vector<FramePairs::Step> steps = scene_.pairs.chain (p);
    std::vector<bool> inverse;
    for (const FramePairs::Step& step : steps)
      inverse.push_back (step.inverse);
    const std::vector<BodyShape>& shapes = shapes_[scene_.pairs[p].from];
    for (int b = 0; b < state.bodies(); ++b)
      visit (std::make_unique<ConcatenationCost> (
                 shapes[b],
                 inverse,
                 concatenationScale (segments_of_body_[b], shapes[b].center.z())),
             b,
             p,
             steps);
  }
}

} // namespace pcl_msf
