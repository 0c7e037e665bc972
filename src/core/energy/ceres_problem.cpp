// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/ceres_problem.h"

namespace pcl_msf {

CeresProblem::CeresProblem (Energy& energy, WindowState& state)
: energy_ (energy)
, state_ (state)
, blocks_ (energy.level().used().size(),
           BodyBlocks (state.body_of, state.bodies(), energy.moving()))
, poses_ (state.poses.size())
, tried_ (state.poses)
{
  unpackPoses();
  ceres::Problem::Options options;
  options.evaluation_callback = this;
  options.disable_all_safety_checks = true;
  problem_ = std::make_unique<ceres::Problem> (options);
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    blocks_[i].addTo (*problem_, state_.poses[energy_.level().used()[i]]);
  energy_.addTo (*problem_, state_, poses_);
}

void
CeresProblem::PrepareForEvaluation (bool evaluate_jacobians, bool)
{
  // Jacobians are wanted where a step starts: Ceres asks for them again at its end.
  const bool starts = linearized_;
  if (!starts)
    energy_.level().sweep (state_, DataTerm::Pass::Linearize);
  linearized_ = false;
  tried_ = state_.poses;
  fill (evaluate_jacobians && starts);
}

/** In place, as the couplings point to them. */
void
CeresProblem::unpackPoses()
{
  for (const int p : energy_.level().used()) {
    poses_[p].resize (state_.poses[p].size());
    for (std::size_t b = 0; b < poses_[p].size(); ++b)
      poses_[p][b] = CoupledPose (state_.poses[p][b]);
  }
}

void
CeresProblem::fill (bool with_jacobians)
{
  unpackPoses();
  const std::vector<int>& used = energy_.level().used();
  for (std::size_t i = 0; i < blocks_.size(); ++i)
    blocks_[i].fill (energy_.level().data (used[i]),
                     state_.poses[used[i]],
                     reach_ ? &(*reach_)[i] : nullptr,
                     with_jacobians);
}

} // namespace pcl_msf
