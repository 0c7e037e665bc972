// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/analytic_scene.h"
#include "support/autodiff_energy.h"
#include "support/kept_problem.h"
#include "support/pose_matcher.h"
#include <ceres/solver.h>

#include <string>

// The compressed blocks against one automatically differentiated residual per pixel:
// the same cost, gradient and Gauss-Newton matrix, and the same optimum from the same
// start.

namespace {

using namespace pcl_msf;

struct Setup {
  const char* name;
  LossType loss;
  double threshold;
  PoseDifference form;
  bool joined; ///< segments 1 and 2 are one body
  int thinning{1};
};

void
PrintTo (const Setup& setup, std::ostream* out)
{
  *out << setup.name;
}

/** Two slanted planes that move apart, and a bar that moves in front of them. */
test::AnalyticScene
twoPlanes ()
{
  test::AnalyticScene s;
  s.camera = {45.0, 44.0, 23.0, 19.5};
  s.width = 48;
  s.height = 40;
  s.quads.push_back ({{-2.0, -2.0, 1.7}, {1.95, 0, 0.5}, {0, 4, 0.6}, 0, 0.4});
  s.quads.push_back ({{0.0, -2.0, 2.1}, {3, 0, -0.7}, {0, 4, -0.3}, 1, 2.9});
  s.quads.push_back ({{0.3, 0.2, 1.5}, {0.25, 0, 0}, {0, 0.2, 0}, 2, 1.0});
  s.motions.push_back (
      test::turnAbout ({-0.7, 0, 2.2}, {0.01, 0.012, -0.02}, {-0.05, 0.01, -0.01}));
  s.motions.push_back (
      test::turnAbout ({0.8, 0, 1.9}, {-0.01, 0.02, 0.01}, {0.01, 0.04, 0.012}));
  s.motions.push_back (test::turnAbout ({0, 0, 0}, {0, 0, 0}, {-0.12, 0.0, 0.0}));
  return s;
}

class Oracle : public testing::TestWithParam<Setup> {
protected:
  Oracle();

  std::vector<double*>
  poses (WindowState& state) const;
  std::vector<double*>
  unknowns (WindowState& state) const; ///< poses, and weights between bodies
  const std::vector<SegmentLink>&
  links () const
  {
    return window_.links;
  }
  const DataTerm&
  data () const
  {
    return level_->data (0);
  }
  bool
  l1 () const
  {
    return energy_.loss == LossType::L1 || energy_.huber_threshold == 0.0;
  }

  test::AnalyticScene scene_{twoPlanes()};
  EnergyParameters energy_;
  std::vector<RgbdFrame> frames_;
  FramePairs pairs_{2, 0};
  WindowScene window_{frames_, pairs_, 3, 1, {}, {0}};
  std::unique_ptr<WindowLevel> level_;
  std::unique_ptr<Energy> joint_;
  WindowState state_;
};

Oracle::Oracle()
{
  energy_.loss = GetParam().loss;
  energy_.huber_threshold = GetParam().threshold;
  energy_.pose_difference = GetParam().form;
  // Plain pose parameters are radians and metres: hundredths where pixels are ones.
  energy_.regularizer_weight = GetParam().form == PoseDifference::Metric ? 0.05 : 500.0;
  energy_.prior_weight = 0.1;
  const test::View reference = scene_.render (false);
  test::View current = scene_.render (true);
  current.depth (cv::Rect (10, 25, 6, 4)) = std::nanf ("");
  current.depth (cv::Rect (6, 8, 5, 4)) += 1.0f;
  cv::Mat labels = reference.body.clone();
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      int& label = labels.at<int> (y, x);
      if (label == 2)
        label = -1;
      else if (label == 1 && y >= labels.rows / 2)
        label = 2;
    }
  FrameParameters plain;
  plain.smoothing_sigma = 0.0;
  frames_ = {scene_.frame (reference, plain), scene_.frame (current, plain)};
  window_.tuning.data.finest_thinning = GetParam().thinning;
  level_ = std::make_unique<WindowLevel> (
      window_, 0, std::vector<cv::Mat>{labels, {}}, energy_);
  const std::vector<Eigen::Vector3d>& centroid = data().pixels().centroid;
  for (const auto& [j, h] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
    const Eigen::Vector3d& a = centroid[j];
    const Eigen::Vector3d& b = centroid[h];
    window_.links.push_back ({j, h, 0.5 * (a + b), 0.5 * (a - b).norm()});
  }
  // Poses about a pixel off the truth, weights of every kind.
  const auto off = [&] (int body, double a, double b) {
    return test::turnAbout (centroid[body],
                            {0.006 * a, -0.01 * b, 0.01 * a},
                            {0.03 * b, -0.02 * a, 0.006 * b}) *
           scene_.motions[body];
  };
  state_ = WindowState (MotionState::fromSegments (
      {off (0, 1, 0.7), off (1, -0.5, 1), off (1, 1, -1)}, links().size()));
  state_.weights = {0.9, 0.7, 1.05};
  if (GetParam().joined) {
    state_.body_of = {0, 1, 1};
    state_.poses[0].pop_back();
  }
  joint_ = std::make_unique<Energy> (*level_, window_, energy_, 0.0, state_);
  level_->sweep (state_, DataTerm::Pass::Linearize); // finds the correspondences
}

std::vector<double*>
Oracle::poses (WindowState& state) const
{
  std::vector<double*> blocks;
  for (RigidPose& pose : state.poses[0])
    blocks.push_back (pose.parameters.data());
  return blocks;
}

std::vector<double*>
Oracle::unknowns (WindowState& state) const
{
  std::vector<double*> blocks = poses (state);
  for (std::size_t i = 0; i < links().size(); ++i)
    if (state.body_of[links()[i].first] != state.body_of[links()[i].second])
      blocks.push_back (&state.weights[i]);
  return blocks;
}

/** What is left of an evaluation when all but the first unknowns are eliminated. */
test::Evaluation
eliminate (const test::Evaluation& all, Eigen::Index kept)
{
  const Eigen::Index rest = all.gradient.size() - kept;
  const Eigen::MatrixXd mixed = all.gauss_newton.topRightCorner (kept, rest);
  const Eigen::MatrixXd solved =
      all.gauss_newton.bottomRightCorner (rest, rest).ldlt().solve (mixed.transpose());
  return {all.cost,
          all.gradient.head (kept) - solved.transpose() * all.gradient.tail (rest),
          all.gauss_newton.topLeftCorner (kept, kept) - mixed * solved};
}

TEST_P (Oracle, EveryKindOfPointTakesPart)
{
  int count[6] = {};
  for (const int active : data().active()) {
    for (int bit = 0; bit < 5; ++bit)
      count[bit] += (active >> bit) & 1;
    count[5] += active == kernel::kBrightness;
  }
  const int t = GetParam().thinning;
  EXPECT_GT (t * count[0], 1000); // brightness
  EXPECT_GT (t * count[1], 1000); // ICP
  EXPECT_GT (t * count[2], 5);    // occluded
  EXPECT_GT (t * count[3], 5);    // out of view
  EXPECT_GT (t * count[4], 5);    // hole
  EXPECT_GT (t * count[5], 5);    // far before the surface that is seen
}

TEST_P (Oracle, CostGradientAndGaussNewtonMatrixAgree)
{
  test::KeptProblem compressed (*joint_, state_);
  const auto plain =
      test::autodiffEnergy (data(), links(), energy_, scene_.camera.fx, state_);
  const std::vector<RigidPose> start = state_.poses[0];
  for (const double step : {0.0, 0.004}) { // at the correspondences' poses and beside
    for (std::size_t b = 0; b < start.size(); ++b)
      for (int i = 0; i < 6; ++i)
        state_.poses[0][b].parameters[i] =
            start[b].parameters[i] + step * (i % 3 - 1.2);
    joint_->relaxWeights (state_);
    const auto a = test::evaluate (compressed.problem(), poses (state_));
    const auto b = eliminate (test::evaluate (*plain, unknowns (state_)),
                              static_cast<Eigen::Index> (6 * start.size()));
    ASSERT_EQ (a.gradient.size(), b.gradient.size());
    EXPECT_NEAR (a.cost / b.cost, 1.0, 1e-10);
    EXPECT_LT ((a.gradient - b.gradient).norm(), 1e-8 * b.gradient.norm());
    EXPECT_LT ((a.gauss_newton - b.gauss_newton).norm(), 1e-8 * b.gauss_newton.norm());
    // Turns are large numbers beside shifts: once more in the scale of each unknown.
    const Eigen::VectorXd scale = b.gauss_newton.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd difference =
        scale.asDiagonal() * (a.gauss_newton - b.gauss_newton) * scale.asDiagonal();
    EXPECT_LT (difference.cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST_P (Oracle, SameOptimumFromTheSameStart)
{
  WindowState other = state_;
  test::KeptProblem compressed (*joint_, state_);
  const auto plain =
      test::autodiffEnergy (data(), links(), energy_, scene_.camera.fx, other);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 500;
  options.function_tolerance = 1e-16;
  options.parameter_tolerance = 1e-14;
  options.gradient_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary a;
  ceres::Solver::Summary b;
  ceres::Solve (options, &compressed.problem(), &a);
  ceres::Solve (options, plain.get(), &b);
  // L1 has a kink at every residual: rounding decides which one a descent ends at. So
  // does a texel's border, of which fewer points average less.
  const double loose = l1() || GetParam().thinning > 1 ? 100.0 : 1.0;
  EXPECT_NEAR (a.final_cost / b.final_cost, 1.0, 1e-8 * loose);
  EXPECT_LT (a.final_cost, 0.6 * a.initial_cost);
  for (std::size_t k = 0; k < state_.poses[0].size(); ++k)
    EXPECT_THAT (state_.poses[0][k],
                 test::isNear (other.poses[0][k], 1e-5 * loose, 1e-5 * loose));
  joint_->relaxWeights (state_);
  for (std::size_t i = 0; i < links().size(); ++i) {
    const SegmentLink& link = links()[i];
    const bool one_body = state_.body_of[link.first] == state_.body_of[link.second];
    EXPECT_NEAR (state_.weights[i], one_body ? 1.0 : other.weights[i], 1e-4 * loose);
  }
}

TEST_P (Oracle, FloatPathFollowsTheDoubleOne)
{
  const auto sum = [&] (bool in_double, int segment) {
    level_->sweep (state_,
                   in_double ? DataTerm::Pass::LinearizeKeptInDouble
                             : DataTerm::Pass::Linearize);
    return data().of (segment);
  };
  // L1's weights are 1 / |r|: a residual near zero magnifies its rounding.
  const double tolerance = l1() ? 1e-2 : 1e-4;
  for (int k = 0; k < data().pixels().segments(); ++k) {
    const SegmentQuadratic exact = sum (true, k);
    const SegmentQuadratic fast = sum (false, k);
    EXPECT_NEAR (fast.brightness_cost / exact.brightness_cost, 1.0, 1e-4);
    EXPECT_NEAR (fast.icp_cost / exact.icp_cost, 1.0, 1e-4);
    const Vector6 scale = exact.information.diagonal().cwiseSqrt().cwiseInverse();
    const Vector6 gradient = scale.cwiseProduct (fast.gradient - exact.gradient);
    EXPECT_LT (gradient.norm(), 1e-4 * std::sqrt (2.0 * exact.cost()));
    const Matrix6 information = scale.asDiagonal() *
                                (fast.information - exact.information) *
                                scale.asDiagonal();
    EXPECT_LT (information.cwiseAbs().maxCoeff(), tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P (
    Energies,
    Oracle,
    testing::Values (
        Setup{"Huber", LossType::Huber, 1.0, PoseDifference::Metric, false},
        Setup{"ZeroThreshold", LossType::Huber, 0.0, PoseDifference::Metric, false},
        Setup{"L1", LossType::L1, 1.0, PoseDifference::Metric, false},
        Setup{"L2", LossType::L2, 1.0, PoseDifference::Metric, false},
        Setup{"Parameters", LossType::Huber, 0.7, PoseDifference::Parameters, false},
        Setup{"JoinedBody", LossType::Huber, 1.0, PoseDifference::Metric, true},
        Setup{"Thinned", LossType::Huber, 1.0, PoseDifference::Metric, false, 2}),
    [] (const testing::TestParamInfo<Setup>& info) {
      return std::string (info.param.name);
    });

} // namespace
