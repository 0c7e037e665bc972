// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "core/motion/flow_evidence.h"

#include <cmath>

namespace {

using namespace pcl_msf;

constexpr PinholeCamera kCamera{100.0, 120.0, 50.0, 40.0};
constexpr double kCap = 4.0;
const RigidPose kRest;

/** A point's flow, (du, dv) away from where the point rests. */
FlowMatch
match (float x, float y, float z, float du, float dv)
{
  FlowMatch m{};
  m.sample = {x,
              y,
              z,
              static_cast<float> (kCamera.fx) * x / z + 50.0f + du,
              static_cast<float> (kCamera.fy) * y / z + 40.0f + dv,
              0.0f};
  m.whitening[0] = m.whitening[2] = 1.0f;
  return m;
}

TEST (FlowEvidence, CostByHand)
{
  FlowMatch sharp = match (0.1f, 0.2f, 2.0f, 3.0f, 4.0f);
  FlowMatch aperture = sharp; // the second direction is not known
  aperture.whitening[2] = 0.0f;
  const FlowEvidence evidence ({sharp, aperture, sharp}, {0, 1, 1, 3}, kCamera, kCap);
  const auto robust = [] (double squared) { return 8.0 * squared / (16.0 + squared); };
  EXPECT_NEAR (evidence.cost (0, kRest), robust (25.0), 1e-4);
  EXPECT_EQ (evidence.cost (1, kRest), 0.0) << "no matches, nothing to say";
  EXPECT_NEAR (evidence.cost (2, kRest), 0.5 * (robust (9.0) + robust (25.0)), 1e-4);
}

TEST (FlowEvidence, LevelsOffFarAwayAndBehindTheCamera)
{
  const FlowEvidence evidence (
      {match (0.0f, 0.0f, 1.0f, 1e5f, 0.0f)}, {0, 1}, kCamera, kCap);
  EXPECT_NEAR (evidence.cost (0, kRest), 0.5 * kCap * kCap, 1e-6);
  RigidPose back;
  back.parameters[5] = -2.0;
  Matrix6 information = Matrix6::Zero();
  Vector6 gradient = Vector6::Zero();
  EXPECT_EQ (evidence.cost (0, back, 1.0, &information, &gradient), 0.5 * kCap * kCap);
  EXPECT_EQ (information.norm(), 0.0);
  EXPECT_EQ (gradient.norm(), 0.0);
}

TEST (FlowEvidence, GradientIsThatOfItsCost)
{
  FlowMatch second = match (-0.3f, 0.1f, 1.5f, -2.0f, 0.5f);
  second.whitening[0] = 0.5f;
  second.whitening[1] = 0.2f;
  const FlowEvidence evidence (
      {match (0.2f, 0.1f, 2.0f, 1.0f, 3.0f), second}, {0, 2}, kCamera, kCap);
  RigidPose pose;
  pose.parameters = {0.02, -0.05, 0.1, 0.01, 0.03, -0.02};
  constexpr double kWeight = 3.0;
  Matrix6 information = Matrix6::Identity(); // added to what is there
  Vector6 gradient = Vector6::Ones();
  evidence.cost (0, pose, kWeight, &information, &gradient);
  for (int i = 0; i < 6; ++i) {
    constexpr double kStep = 1e-5;
    RigidPose low = pose;
    RigidPose high = pose;
    low.parameters[i] -= kStep;
    high.parameters[i] += kStep;
    const double slope =
        (evidence.cost (0, high) - evidence.cost (0, low)) / (2.0 * kStep);
    EXPECT_NEAR (gradient[i] - 1.0, kWeight * slope, 1e-4 * (1.0 + std::abs (slope)))
        << i;
  }
  EXPECT_GT (information.determinant(), 1.0);
  EXPECT_LT ((information - information.transpose()).norm(), 1e-9);
}

} // namespace
