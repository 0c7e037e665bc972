// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/motion/rigid_fit.h"

#include <random>

namespace {

using namespace pcl_msf;

const RigidFitOptions kOptions{{500.0, 500.0, 320.0, 240.0}, 0.001, 0.001, {0.5, 20}};

struct Samples {
  std::vector<FlowSample> all;
  std::vector<Eigen::Vector3d> points;
};

/** A body of 0.6 m at 2 m; a share of the samples has wild flow and depth. */
Samples
seen (const RigidPose& motion, int count, double wild, std::mt19937& generator)
{
  std::uniform_real_distribution<double> uniform (-1.0, 1.0);
  Samples result;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p (0.3 * uniform (generator),
                             0.3 * uniform (generator),
                             2.0 + 0.3 * uniform (generator));
    const Eigen::Vector3d q = motion * p;
    const Eigen::Vector2d uv = kOptions.camera.project (q);
    FlowSample s{static_cast<float> (p.x()),
                 static_cast<float> (p.y()),
                 static_cast<float> (p.z()),
                 static_cast<float> (uv.x()),
                 static_cast<float> (uv.y()),
                 static_cast<float> (1.0 / q.z())};
    if (i < wild * count) {
      s.u += static_cast<float> (80.0 * uniform (generator));
      s.v += static_cast<float> (80.0 * uniform (generator));
      s.inverse_depth *= static_cast<float> (1.0 + 0.3 * uniform (generator));
    }
    result.all.push_back (s);
    result.points.push_back (p);
  }
  return result;
}

/** Mean distance between where two motions take the points, metres. */
double
distance (const RigidPose& a, const RigidPose& b, const Samples& samples)
{
  double sum = 0.0;
  for (const Eigen::Vector3d& p : samples.points)
    sum += (a * p - b * p).norm();
  return sum / static_cast<double> (samples.points.size());
}

RigidPose
motionOf (double angle)
{
  RigidPose pose;
  pose.parameters = {0.5 * angle, -0.6 * angle, 0.6 * angle, 0.03, -0.02, 0.05};
  return pose;
}

class RigidFit : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P (RigidFit, FindsTheMotionDespiteWildSamples)
{
  const auto [angle, wild] = GetParam();
  std::mt19937 generator (6);
  const RigidPose motion = motionOf (angle);
  const Samples s = seen (motion, 500, wild, generator);
  const RigidPose found = fitRigidMotion (s.all.data(), 500, {}, kOptions);
  // A pixel is 4 mm there; the weak rotation prior and wild samples leave a tenth.
  EXPECT_LT (distance (found, motion, s), 0.0004);
  EXPECT_GT (distance ({}, motion, s), 0.02);
}

INSTANTIATE_TEST_SUITE_P (AnglesAndOutliers,
                          RigidFit,
                          testing::Combine (testing::Values (0.0, 0.02, 0.08),
                                            testing::Values (0.0, 0.2, 0.4)));

TEST (RigidFitEdges, StartsFromTheGuess)
{
  std::mt19937 generator (7);
  const RigidPose motion = motionOf (0.05);
  const Samples s = seen (motion, 200, 0.0, generator);
  RigidFitOptions none = kOptions;
  none.tuning.iterations = 0;
  EXPECT_LT (distance (fitRigidMotion (s.all.data(), 200, motion, none), motion, s),
             1e-9);
}

TEST (RigidFitEdges, UnknownDepthIsLeftOut)
{
  std::mt19937 generator (8);
  const RigidPose motion = motionOf (0.03);
  Samples s = seen (motion, 300, 0.0, generator);
  for (FlowSample& sample : s.all)
    sample.inverse_depth = 0.0f;
  const RigidPose found = fitRigidMotion (s.all.data(), 300, {}, kOptions);
  EXPECT_LT (distance (found, motion, s), 0.01); // the depth is known least
  double worst = 0.0;
  for (const Eigen::Vector3d& p : s.points)
    worst = std::max (
        worst,
        (kOptions.camera.project (found * p) - kOptions.camera.project (motion * p))
            .norm());
  EXPECT_LT (worst, 0.5); // pixels
}

TEST (RigidFitEdges, FewSamplesStayFinite)
{
  std::mt19937 generator (9);
  const Samples s = seen (motionOf (0.05), 3, 0.0, generator);
  for (int count = 0; count <= 3; ++count)
    EXPECT_TRUE (fitRigidMotion (s.all.data(), count, {}, kOptions).isFinite());
}

TEST (RigidFitEdges, MeanErrorIsTruncated)
{
  std::mt19937 generator (10);
  const RigidPose motion = motionOf (0.05);
  const Samples s = seen (motion, 400, 0.25, generator);
  const auto error = [&] (const RigidPose& pose, double limit) {
    return meanTruncatedError (s.all.data(), 400, pose, kOptions, limit);
  };
  EXPECT_LE (error (motion, 3.0), 0.25 * 3.0 + 1e-3);
  EXPECT_GT (error (motion, 3.0), 0.2 * 3.0);
  EXPECT_NEAR (error ({}, 1.0), 1.0, 0.02); // all are off
  EXPECT_EQ (meanTruncatedError (nullptr, 0, motion, kOptions, 3.0), 0.0);
}

} // namespace
