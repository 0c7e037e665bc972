// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/window_level.h"
#include "core/energy/concatenation_cost.h"
#include "core/energy/pose_coupling.h"
#include <ceres/problem.h>
#include <pcl_msf/parameters.h>
#include <pcl_msf/scene_flow.h>

#include <vector>

namespace pcl_msf {

/** \brief Per pair and body. */
using CoupledPoses = std::vector<std::vector<CoupledPose>>;

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

/** \brief The energy body by body. */
struct BodyCosts {
  std::vector<double> of; ///< per body; a link counts for both of its bodies
  double total{0.0};      ///< of all; a link counts once
};

/** \brief The energy of Eq. 13 on one level: data terms and coupling of every pair,
 * weights and their prior shared, and the concatenation of non-adjacent pairs. With one
 * pair it is Eq. 5. */
class Energy {
public:
  /** \param state whose bodies the energy is for; its poses tell where the links and
   * the bodies lie in the other frames */
  Energy (WindowLevel& level,
          const WindowScene& scene,
          const EnergyParameters& parameters,
          double concatenation_weight,
          const WindowState& state);

  /** \brief Lets only some bodies move; before, all do. \param moving per body: may it
   * move? */
  void
  letMove (std::vector<char> moving)
  {
    moving_ = std::move (moving);
  }
  /** \brief What letMove () was given; empty: all move. */
  const std::vector<char>&
  moving () const
  {
    return moving_;
  }

  /** \brief The energy by term; linearizes the data terms at the state. */
  EnergyCost
  evaluate (const WindowState& state);

  /** \brief Whether weights are no unknowns: where one pair alone pulls at each, it is
   * at its optimum for the poses all the time. */
  bool
  eliminatesWeights () const
  {
    return scene_.used.size() == 1;
  }

  /** \brief As evaluate, with the data terms of the last sweep. */
  EnergyCost
  presentCost (const WindowState& state) const;

  /** \brief Sets every weight to its optimum for the poses of all pairs. */
  void
  relaxWeights (WindowState& state) const;

  /** \brief Adds what ties poses to a problem over the state: one block per link
   * between bodies and pair, whose weight, unless eliminated, all pairs share and whose
   * prior only the first pair's block carries; per non-adjacent pair one concatenation
   * per body. Bodies that may not move are constant, what ties them alone is left out.
   * \param poses of the state as it is evaluated, per pair and body */
  void
  addTo (ceres::Problem& problem, WindowState& state, const CoupledPoses& poses) const;

  ResidualCounts
  countResiduals () const;

  /** \brief What the energy says of each body, from the data terms' last sums: those of
   * its segments, its links at their best weights, its concatenation. */
  BodyCosts
  bodyCosts (const WindowState& state) const;

  const std::vector<int>&
  segmentsOf (int body) const
  {
    return segments_of_body_[body];
  }
  /** \brief The frame that a pair's points come from. */
  int
  frameOf (int pair) const
  {
    return scene_.pairs[pair].from;
  }
  const StepTuning&
  stepTuning () const
  {
    return scene_.tuning.solve.step;
  }

  WindowLevel&
  level ()
  {
    return level_;
  }

private:
  bool
  moves (int body) const
  {
    return moving_.empty() || moving_[body] != 0;
  }
  double
  unit (double depth) const;
  double
  priorWeight () const;
  double
  weightAt (double squared_difference) const;
  void
  addCouplings (ceres::Problem& problem,
                WindowState& state,
                const CoupledPoses& poses) const;
  void
  carryShapes (const WindowState& state);
  /** Calls visit (body, cost, parameter blocks) for every body and non-adjacent pair.
   */
  template <typename State, typename Visitor>
  void
  forEachConcatenation (State& state, const Visitor& visit) const;
  std::vector<double>
  concatenationCosts (const WindowState& state) const;
  std::vector<double>
  squaredDifferences (const WindowState& state) const;

  WindowLevel& level_;
  const WindowScene& scene_;
  const EnergyParameters& parameters_;
  double concatenation_weight_;
  std::vector<char> moving_;                    ///< per body; empty: all
  std::vector<std::vector<SegmentLink>> links_; ///< per frame that a pair starts from
  std::vector<std::vector<int>> segments_of_body_;
  std::vector<std::vector<BodyShape>> shapes_; ///< per frame, per body; empty when
                                               ///< all pairs are adjacent
};

} // namespace pcl_msf
