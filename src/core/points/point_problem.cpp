// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/point_problem.h"

#include "core/energy/sparse_cholesky.h"
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>

namespace pcl_msf {

namespace {

constexpr int kDense = 6; // blocks per pose: a surface's own segments have about 4

ceres::Problem::Options
optionsWith (ceres::EvaluationCallback* callback)
{
  ceres::Problem::Options options;
  options.evaluation_callback = callback;
  options.disable_all_safety_checks = true;
  return options;
}

} // namespace

PointProblem::PointProblem() : problem_ (optionsWith (this)) {}

void
PointProblem::add (PointTerms& terms)
{
  terms_.push_back (&terms);
  terms.addTo (problem_);
}

void
PointProblem::addChain (PointTerms& direct,
                        PointTerms& first,
                        PointTerms& second,
                        const std::vector<BodyShape>& shapes,
                        double weight)
{
  const double scale = std::sqrt (weight / std::max (1, direct.size())) / direct.unit();
  for (int k = 0; k < direct.size(); ++k)
    problem_.AddResidualBlock (new ChainCost (direct.motions()[k],
                                              first.motions()[k],
                                              second.motions()[k],
                                              shapes[k],
                                              scale),
                               nullptr,
                               direct.step (k),
                               first.step (k),
                               second.step (k));
}

void
PointProblem::PrepareForEvaluation (bool evaluate_jacobians, bool)
{
  // After its last step Ceres asks for derivatives that nobody will use; the cost of
  // that place is there already.
  if (evaluate_jacobians && derivatives_-- <= 0)
    return;
  for (PointTerms* terms : terms_)
    terms->fill (evaluate_jacobians);
}

double
PointProblem::step (int iterations)
{
  ceres::Solver::Options options;
  // Chains would fill the factor, and so would segments that lie among each other.
  const bool fills = terms_.size() > 1 || problem_.NumResidualBlocks() >
                                              kDense * problem_.NumParameterBlocks();
  if (fills)
    options.linear_solver_type = ceres::CGNR;
  else
    useSparseCholesky (options);
  options.max_num_iterations = iterations;
  options.function_tolerance = 1e-3;
  options.gradient_tolerance = 0.0;
  options.parameter_tolerance = 0.0;
  options.initial_trust_region_radius = 1e6;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1; // the sweep is parallel; the rest is small
  derivatives_ = iterations;
  ceres::Solver::Summary summary;
  ceres::Solve (options, &problem_, &summary);
  for (PointTerms* terms : terms_)
    terms->finish();
  return summary.final_cost;
}

} // namespace pcl_msf
