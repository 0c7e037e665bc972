// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/joint_solver.h"

#include "core/joint_problem.h"
#include "core/pose_coupling.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

double
JointEnergy::unit (const SegmentLink& link) const
{
  return focal_length_ / std::max (link.midpoint.z(), 1e-3);
}

double
JointEnergy::squaredDifference (int i,
                                const UnpackedPose& first,
                                const UnpackedPose& second) const
{
  const SegmentLink& link = links_[i];
  return poseDifference (first, second, link, unit (link), parameters_.pose_difference)
      .squaredNorm();
}

double
JointEnergy::linkStrength (int i,
                           const UnpackedPose& first,
                           const UnpackedPose& second) const
{
  const double eta = parameters_.prior_weight;
  return eta /
         (parameters_.regularizer_weight * squaredDifference (i, first, second) + eta);
}

double
JointEnergy::couplingCost (int i,
                           const UnpackedPose& first,
                           const UnpackedPose& second) const
{
  const double misfit =
      parameters_.regularizer_weight * squaredDifference (i, first, second);
  const double eta = parameters_.prior_weight;
  return 0.5 * misfit * eta / ((misfit + eta) * links_.size());
}

void
JointEnergy::relaxWeights (MotionState& state) const
{
  const std::vector<UnpackedPose> poses (state.poses.begin(), state.poses.end());
  for (std::size_t i = 0; i < links_.size(); ++i)
    state.weights[i] =
        std::sqrt (linkStrength (static_cast<int> (i),
                                 poses[state.body_of[links_[i].first]],
                                 poses[state.body_of[links_[i].second]]));
}

EnergyCost
JointEnergy::evaluate (const MotionState& state)
{
  data_.sweep (state, DataTerm::Pass::Linearize);
  return presentCost (state);
}

EnergyCost
JointEnergy::presentCost (const MotionState& state) const
{
  EnergyCost cost;
  for (int k = 0; k < data_.pixels().segments(); ++k) {
    cost.brightness += data_.of (k).brightness_cost;
    cost.icp += data_.of (k).icp_cost;
  }
  const double share = 0.5 / std::max<std::size_t> (1, links_.size());
  const std::vector<UnpackedPose> poses (state.poses.begin(), state.poses.end());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const double s = state.weights[i] * state.weights[i];
    const double d2 = squaredDifference (static_cast<int> (i),
                                         poses[state.body_of[links_[i].first]],
                                         poses[state.body_of[links_[i].second]]);
    cost.regularizer += share * parameters_.regularizer_weight * s * s * d2;
    cost.prior += share * parameters_.prior_weight * (1.0 - s) * (1.0 - s);
  }
  return cost;
}

SolveOutcome
JointEnergy::minimize (const SolverParameters& solver,
                       SolveMonitor& monitor,
                       MotionState& state)
{
  return minimizeEnergy<JointProblem> (*this, state, solver, monitor);
}

} // namespace pcl_msf
