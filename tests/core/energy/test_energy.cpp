// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/energy/minimize.h"
#include "support/autodiff_energy.h"
#include "support/kept_problem.h"
#include "support/two_planes.h"
#include "support/window_scene.h"
#include <ceres/rotation.h>

// The energy of a window: residuals counted as in Eq. 15, and the compressed blocks
// against one automatically differentiated residual per pixel, body and link.

namespace {

using namespace pcl_msf;

constexpr double kLambda = 3.0;

EnergyParameters
energyParameters ()
{
  EnergyParameters energy;
  energy.regularizer_weight = 0.05;
  energy.prior_weight = 0.1;
  return energy;
}

class Window : public testing::Test {
protected:
  void
  make (int frames, int reference)
  {
    scene_ =
        std::make_unique<test::EnergyWindow> (test::twoPlanes(), frames, reference);
    level_ =
        std::make_unique<WindowLevel> (scene_->window, 0, scene_->labels, parameters_);
    energy_ = std::make_unique<Energy> (
        *level_, scene_->window, parameters_, kLambda, scene_->state);
  }

  const EnergyParameters parameters_ = energyParameters();
  std::unique_ptr<test::EnergyWindow> scene_;
  std::unique_ptr<WindowLevel> level_;
  std::unique_ptr<Energy> energy_;
};

TEST_F (Window, CountsResidualsAsEquation15)
{
  const int non_adjacent[] = {0, 1, 3}; // K (N - 2) at N = 3, one more per segment at 4
  for (const int n : {2, 3, 4}) {
    make (n, 0);
    const int pairs = n * (n - 1) / 2;
    int pixels = 0;
    int normals = 0;
    for (const FramePairs::Pair& pair : scene_->pairs.all()) {
      const FrameLevel& from = scene_->frames[pair.from].levels()[0];
      for (int y = 0; y < from.height(); ++y)
        for (int x = 0; x < from.width(); ++x) {
          const bool counts = scene_->labels[pair.from].at<int> (y, x) >= 0;
          pixels += counts;
          normals += counts && from.normals.at<cv::Vec3f> (y, x)[2] != 0.0f;
        }
    }
    const ResidualCounts counts = energy_->countResiduals();
    EXPECT_EQ (counts.brightness, pixels);
    EXPECT_EQ (counts.icp, normals);
    EXPECT_EQ (counts.regularizer, pairs * 1);
    EXPECT_EQ (counts.prior, 1);
    EXPECT_EQ (counts.concatenation, 2 * non_adjacent[n - 2]);
    EXPECT_EQ (counts.total(),
               pixels + normals + (pairs + 1) * 1 + 2 * non_adjacent[n - 2]);
  }
}

TEST_F (Window, TrueMotionsCostLeast)
{
  make (3, 0);
  const double best = energy_->evaluate (scene_->state).total();
  EXPECT_NEAR (energy_->evaluate (scene_->state).concatenation, 0.0, 1e-15);
  for (std::size_t p = 0; p < scene_->state.poses.size(); ++p) {
    WindowState off = scene_->state;
    off.poses[p][1].parameters[3] += 0.01;
    EXPECT_GT (energy_->evaluate (off).total(), best) << p;
  }
}

/** Eq. 14 for one body and a chain of two steps forward. */
struct TwoSteps {
  BodyShape shape;
  double scale;

  template <typename T>
  bool
  operator() (const T* own, const T* first, const T* second, T* residual) const
  {
    for (int column = 0; column < 4; ++column) {
      const Eigen::Vector3d v =
          column == 0 ? shape.center : Eigen::Vector3d (shape.spread.col (column - 1));
      const T start[3] = {T (v.x()), T (v.y()), T (v.z())};
      T direct[3], between[3], chained[3];
      ceres::AngleAxisRotatePoint (own, start, direct);
      ceres::AngleAxisRotatePoint (first, start, between);
      for (int i = 0; column == 0 && i < 3; ++i) {
        direct[i] += own[3 + i];
        between[i] += first[3 + i];
      }
      ceres::AngleAxisRotatePoint (second, between, chained);
      for (int i = 0; column == 0 && i < 3; ++i)
        chained[i] += second[3 + i];
      for (int i = 0; i < 3; ++i)
        residual[3 * column + i] = scale * (direct[i] - chained[i]);
    }
    return true;
  }
};

/** Mean and a root of the covariance of a segment's points, computed anew. */
BodyShape
shapeOf (const SegmentPixels& points, int segment)
{
  BodyShape shape;
  const int n = points.size (segment);
  for (int i = points.begin[segment]; i < points.begin[segment + 1]; ++i)
    shape.center += Eigen::Vector3d (points.x[i], points.y[i], points.z[i]) / n;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (int i = points.begin[segment]; i < points.begin[segment + 1]; ++i) {
    const Eigen::Vector3d d =
        Eigen::Vector3d (points.x[i], points.y[i], points.z[i]) - shape.center;
    covariance += d * d.transpose() / n;
  }
  shape.spread = covariance.llt().matrixL();
  return shape;
}

std::vector<double*>
unknowns (WindowState& state)
{
  std::vector<double*> blocks;
  for (auto& poses : state.poses)
    for (RigidPose& pose : poses)
      blocks.push_back (pose.parameters.data());
  blocks.push_back (&state.weights[0]);
  return blocks;
}

TEST_F (Window, AgreesWithOneAutomaticResidualPerPixel)
{
  make (3, 0);
  WindowState& state = scene_->state;
  const WindowState truth = state;
  for (std::size_t p = 0; p < state.poses.size(); ++p)
    for (int b = 0; b < 2; ++b)
      for (int i = 0; i < 6; ++i)
        state.poses[p][b].parameters[i] += 0.003 * ((i + p + b) % 3 - 1.2);
  level_->sweep (state, DataTerm::Pass::Linearize); // finds the correspondences
  ceres::Problem plain;
  for (const int p : scene_->window.used) {
    for (int k = 0; k < 2; ++k)
      test::addSegment (
          level_->data (p), k, state.poses[p][k].parameters.data(), plain);
    SegmentLink link = scene_->window.links[0];
    const int from = scene_->pairs[p].from;
    if (from != 0) {
      const auto& carried = truth.poses[scene_->pairs.fromReference (from)];
      link.midpoint = 0.5 * (carried[0] * scene_->window.centroids[0] +
                             carried[1] * scene_->window.centroids[1]);
    }
    plain.AddResidualBlock (
        new ceres::AutoDiffCostFunction<test::LinkResidual, 7, 6, 6, 1> (
            new test::LinkResidual{link,
                                   parameters_.pose_difference,
                                   scene_->scene.camera.fx / link.midpoint.z(),
                                   std::sqrt (parameters_.regularizer_weight),
                                   p == 0 ? std::sqrt (3.0 * parameters_.prior_weight)
                                          : 0.0}),
        nullptr,
        state.poses[p][0].parameters.data(),
        state.poses[p][1].parameters.data(),
        &state.weights[0]);
  }
  const int own = scene_->pairs.between (0, 2);
  const int first = scene_->pairs.between (0, 1);
  const int second = scene_->pairs.between (1, 2);
  for (int b = 0; b < 2; ++b) {
    const BodyShape shape = shapeOf (level_->pixels (0), b);
    plain.AddResidualBlock (
        new ceres::AutoDiffCostFunction<TwoSteps, 12, 6, 6, 6> (new TwoSteps{
            shape,
            std::sqrt (kLambda / 2) * scene_->scene.camera.fx / shape.center.z()}),
        nullptr,
        state.poses[own][b].parameters.data(),
        state.poses[first][b].parameters.data(),
        state.poses[second][b].parameters.data());
  }
  test::KeptProblem compressed (*energy_, state);
  const auto a = test::evaluate (compressed.problem(), unknowns (state));
  const auto b = test::evaluate (plain, unknowns (state));
  EXPECT_GT (b.cost, 0.0);
  EXPECT_NEAR (a.cost, b.cost, 1e-10 * b.cost);
  EXPECT_LT ((a.gradient - b.gradient).norm(), 1e-8 * b.gradient.norm());
  EXPECT_LT ((a.gauss_newton - b.gauss_newton).norm(), 1e-8 * b.gauss_newton.norm());
}

TEST_F (Window, OptimumIsNearTheTruthFromBesideIt)
{
  for (const int reference : {0, 1}) {
    make (3, reference);
    WindowState state = scene_->state;
    for (std::size_t p = 0; p < state.poses.size(); ++p)
      for (RigidPose& pose : state.poses[p])
        pose.parameters[3] += p % 2 ? 0.008 : -0.008;
    SolverParameters solver;
    solver.max_iterations = 20;
    solver.function_tolerance = 1e-8;
    SolveMonitor monitor (solver);
    const SolveOutcome outcome = minimize (*energy_, solver, monitor, state);
    EXPECT_LT (outcome.final.total(), outcome.initial.total());
    for (std::size_t p = 0; p < state.poses.size(); ++p)
      for (int b = 0; b < 2; ++b) {
        const Eigen::Vector3d at = scene_->window.centroids[b];
        EXPECT_LT ((state.poses[p][b] * at - scene_->state.poses[p][b] * at).norm(),
                   0.004) // a tenth of a pixel
            << "pair " << p << " body " << b;
      }
  }
}

} // namespace
