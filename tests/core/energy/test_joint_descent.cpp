// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/energy/joint_descent.h"
#include "support/two_planes.h"
#include "support/window_scene.h"

namespace {

using namespace pcl_msf;

constexpr double kForever = 1e9;

class Descent : public testing::TestWithParam<int> {
protected:
  Descent()
  : scene_ (test::twoPlanes(), GetParam(), 0)
  , level_ (scene_.window, 0, scene_.labels, parameters_)
  , energy_ (level_, scene_.window, parameters_, 3.0, scene_.state)
  {
    solver_.parameter_tolerance = 0.0;
  }

  /** The true state with one body moved, in every frame alike. */
  WindowState
  moved (int body, double metres) const
  {
    WindowState state = scene_.state;
    for (std::size_t p = 0; p < state.poses.size(); ++p)
      if (scene_.pairs[p].from == 0)
        state.poses[p][body].parameters[3] += metres;
    return state;
  }

  const EnergyParameters parameters_{};
  SolverParameters solver_;
  test::EnergyWindow scene_;
  WindowLevel level_;
  Energy energy_;
};

TEST_P (Descent, CostsOfBodiesAddUpToTheEnergy)
{
  WindowState state = moved (1, 0.02);
  energy_.relaxWeights (state);
  const double total = energy_.evaluate (state).total();
  const BodyCosts costs = energy_.bodyCosts (state);
  EXPECT_NEAR (costs.total, total, 1e-9 * total);
  EXPECT_GT (costs.of[1], energy_.bodyCosts (scene_.state).of[0]);
  EXPECT_GE (costs.of[0] + costs.of[1], costs.total); // the link counts twice
}

TEST_P (Descent, NoStepRaisesTheEnergyAndItsSumsAreThoseOfTheState)
{
  WindowState state = moved (0, 0.01);
  state.poses[0][1].parameters[4] += 0.3; // beyond what its images tell
  energy_.relaxWeights (state);
  double cost = energy_.evaluate (state).total();
  JointDescent descent (energy_, solver_, state);
  for (int i = 0; i < 5; ++i) {
    const WindowState before = state;
    const bool lower = descent.step (kForever);
    if (lower)
      EXPECT_LT (descent.cost(), cost) << i;
    else
      EXPECT_EQ (state.poses[0][0].parameters, before.poses[0][0].parameters) << i;
    cost = descent.cost();
    level_.completeSums();
    EXPECT_NEAR (energy_.evaluate (state).total(), cost, 1e-9 * cost) << i;
  }
}

TEST_P (Descent, ALostBodyDoesNotHoldUpTheOther)
{
  WindowState state = moved (0, 0.01);
  for (std::size_t p = 0; p < state.poses.size(); ++p)
    state.poses[p][1].parameters[4] += 0.3;
  energy_.relaxWeights (state);
  energy_.evaluate (state);
  JointDescent descent (energy_, solver_, state);
  for (int i = 0; i < 8; ++i)
    descent.step (kForever);
  const Eigen::Vector3d at = scene_.window.centroids[0];
  for (std::size_t p = 0; p < state.poses.size(); ++p)
    EXPECT_LT ((state.poses[p][0] * at - scene_.state.poses[p][0] * at).norm(), 0.004)
        << p;
}

TEST_P (Descent, BodiesThatMayNotMoveStayAndTheOthersAreDrawnToThem)
{
  WindowState state = moved (0, 0.01);
  for (std::size_t p = 0; p < state.poses.size(); ++p)
    state.poses[p][1].parameters[4] += 0.01;
  const WindowState before = state;
  energy_.letMove ({1, 0});
  energy_.relaxWeights (state);
  const double cost = energy_.evaluate (state).total();
  JointDescent descent (energy_, solver_, state);
  for (int i = 0; i < 8; ++i)
    descent.step (kForever);
  EXPECT_LT (descent.cost(), cost);
  const Eigen::Vector3d at = scene_.window.centroids[0];
  for (std::size_t p = 0; p < state.poses.size(); ++p) {
    EXPECT_EQ (state.poses[p][1].parameters, before.poses[p][1].parameters) << p;
    EXPECT_LT ((state.poses[p][0] * at - scene_.state.poses[p][0] * at).norm(), 0.004)
        << p;
  }
}

TEST_P (Descent, WithoutBodiesThatMayMoveNothingChanges)
{
  WindowState state = moved (0, 0.01);
  const WindowState before = state;
  energy_.letMove ({0, 0});
  energy_.relaxWeights (state);
  energy_.evaluate (state);
  JointDescent (energy_, solver_, state).step (kForever);
  for (std::size_t p = 0; p < state.poses.size(); ++p)
    for (int b = 0; b < 2; ++b)
      EXPECT_EQ (state.poses[p][b].parameters, before.poses[p][b].parameters);
}

INSTANTIATE_TEST_SUITE_P (Frames, Descent, testing::Values (2, 3));

} // namespace
