// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/joint_problem.h"

#include "core/pose_coupling.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

JointProblem::JointProblem (JointEnergy& energy, MotionState& state)
: energy_ (energy), state_ (state), blocks_ (state.body_of, state.poses.size())
{
  ceres::Problem::Options options;
  options.evaluation_callback = this;
  options.disable_all_safety_checks = true;
  problem_ = std::make_unique<ceres::Problem> (options);
  blocks_.addTo (*problem_, state.poses);
  addLinks();
}

void
JointProblem::addLinks()
{
  const auto& links = energy_.links_;
  const EnergyParameters& p = energy_.parameters_;
  if (p.regularizer_weight <= 0.0)
    return;
  const double share = 1.0 / std::max<std::size_t> (1, links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    const int j = state_.body_of[links[i].first];
    const int h = state_.body_of[links[i].second];
    if (j == h)
      continue;
    const CouplingScale scale{std::sqrt (share * p.regularizer_weight),
                              std::sqrt (share * p.prior_weight),
                              energy_.unit (links[i])};
    problem_->AddResidualBlock (
        new PoseCouplingCost (links[i], scale, p.pose_difference),
        nullptr,
        state_.poses[j].parameters.data(),
        state_.poses[h].parameters.data(),
        &state_.weights[i]);
  }
}

void
JointProblem::PrepareForEvaluation (bool evaluate_jacobians, bool)
{
  using Pass = DataTerm::Pass;
  DataTerm& data = energy_.data_;
  const Pass jacobian_pass = keep_ ? Pass::LinearizeKept : Pass::Linearize;
  if (!linearized_ || !evaluate_jacobians)
    data.sweep (state_, evaluate_jacobians ? jacobian_pass : Pass::Cost);
  linearized_ = false;
  blocks_.fill (data, evaluate_jacobians);
}

} // namespace pcl_msf
