// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/joint_problem.h"

#include "core/pose_coupling.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf {

JointProblem::JointProblem (JointEnergy& energy, MotionState& state)
: energy_ (energy)
, state_ (state)
, segments_of_ (state.poses.size())
, blocks_ (state.poses.size())
{
  for (std::size_t k = 0; k < state.body_of.size(); ++k)
    segments_of_[state.body_of[k]].push_back (static_cast<int> (k));
  ceres::Problem::Options options;
  options.evaluation_callback = this;
  options.disable_all_safety_checks = true;
  problem_ = std::make_unique<ceres::Problem> (options);
  addBodies();
  addLinks();
}

void
JointProblem::addBodies()
{
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    problem_->AddResidualBlock (
        new SegmentBlockCost (blocks_[b]), nullptr, state_.poses[b].parameters.data());
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
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    Matrix6 information = Matrix6::Zero();
    Vector6 gradient = Vector6::Zero();
    double cost = 0.0;
    for (const int k : segments_of_[b]) {
      cost += data.of (k).cost();
      if (evaluate_jacobians) {
        information += data.of (k).information;
        gradient += data.of (k).gradient;
      }
    }
    if (evaluate_jacobians)
      blocks_[b].set (information, gradient, cost);
    else
      blocks_[b].setCost (cost);
  }
}

} // namespace pcl_msf
