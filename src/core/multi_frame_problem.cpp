// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/multi_frame_problem.h"

#include "core/pose_coupling.h"

#include <cmath>

namespace pcl_msf {

MultiFrameProblem::MultiFrameProblem (MultiFrameEnergy& energy, MultiFrameState& state)
: energy_ (energy)
, state_ (state)
, blocks_ (energy.scene_.used.size(), BodyBlocks (state.body_of, state.bodies()))
{
  ceres::Problem::Options options;
  options.evaluation_callback = this;
  options.disable_all_safety_checks = true;
  problem_ = std::make_unique<ceres::Problem> (options);
  addBodies();
  addLinks();
  addConcatenations();
}

void
MultiFrameProblem::addBodies()
{
  const std::vector<int>& used = energy_.scene_.used;
  for (std::size_t i = 0; i < used.size(); ++i)
    blocks_[i].addTo (*problem_, state_.poses[used[i]]);
}

void
MultiFrameProblem::addLinks()
{
  const MultiFrameScene& scene = energy_.scene_;
  if (energy_.energy_.regularizer_weight <= 0.0)
    return;
  for (std::size_t i = 0; i < scene.links.size(); ++i) {
    const int j = state_.body_of[scene.links[i].first];
    const int h = state_.body_of[scene.links[i].second];
    if (j == h)
      continue;
    for (const int p : scene.used) {
      const SegmentLink& link = energy_.links_[scene.pairs[p].from][i];
      const bool first = p == scene.used.front();
      problem_->AddResidualBlock (
          new PoseCouplingCost (link,
                                energy_.couplingScale (link, first),
                                energy_.energy_.pose_difference),
          nullptr,
          state_.poses[p][j].parameters.data(),
          state_.poses[p][h].parameters.data(),
          &state_.weights[i]);
    }
  }
}

void
MultiFrameProblem::addConcatenations()
{
  if (energy_.concatenation_weight_ <= 0.0)
    return;
  const auto add = [this] (std::unique_ptr<ConcatenationCost> cost,
                           int body,
                           int pair,
                           const std::vector<FramePairs::Step>& steps) {
    std::vector<double*> blocks{state_.poses[pair][body].parameters.data()};
    for (const FramePairs::Step& step : steps)
      blocks.push_back (state_.poses[step.pair][body].parameters.data());
    problem_->AddResidualBlock (cost.release(), nullptr, blocks);
  };
  energy_.forEachConcatenation (state_, add);
}

void
MultiFrameProblem::PrepareForEvaluation (bool evaluate_jacobians, bool)
{
  using Pass = DataTerm::Pass;
  const Pass jacobian_pass = keep_ ? Pass::LinearizeKept : Pass::Linearize;
  if (!linearized_ || !evaluate_jacobians)
    energy_.level_.sweep (state_, evaluate_jacobians ? jacobian_pass : Pass::Cost);
  linearized_ = false;
  const std::vector<int>& used = energy_.scene_.used;
  for (std::size_t i = 0; i < used.size(); ++i)
    blocks_[i].fill (energy_.level_.data (used[i]), evaluate_jacobians);
}

} // namespace pcl_msf
