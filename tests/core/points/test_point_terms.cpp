// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/points/cloud_joints.h"
#include "core/points/part_merging.h"
#include "core/points/part_seams.h"
#include "core/points/point_matching.h"
#include "core/points/rigid_moments.h"
#include "core/points/seam_cost.h"
#include "core/points/segment_start.h"
#include "support/pose_matcher.h"

#include <array>
#include <cmath>
#include <random>

namespace {

using namespace pcl_msf;

const RigidPose kPose{{0.4, -0.9, 0.3, 0.2, -0.1, 0.5}};

TEST (PointPull, IsPointToPlaneAndPointToPoint)
{
  const Eigen::Vector3d q (0.3, -0.2, 0.8);
  const Eigen::Vector3d n = Eigen::Vector3d (1.0, 2.0, -2.0) / 3.0;
  const Eigen::Vector3d x (0.5, 0.1, 0.4);
  PointPull pull;
  pull.add (q, n, 2.0, 0.1);
  // d = (0.2, 0.3, -0.4): n'd = (0.2 + 0.6 + 0.8) / 3, d'd = 0.29
  const double plane = 1.6 / 3.0;
  EXPECT_NEAR (0.5 * x.dot (pull.a * x) - pull.b.dot (x) + pull.c,
               0.5 * 2.0 * (plane * plane + 0.1 * 0.29),
               1e-12);
  EXPECT_DOUBLE_EQ (pull.weight, 2.0);
}

TEST (SeamCost, DerivativesAgreeWithDifferences)
{
  const Eigen::Vector3d a (0.1, 0.2, 0.3);
  const Eigen::Vector3d b (0.5, 0.1, 0.2);
  const std::vector<CenteredMotion> motions{CenteredMotion (kPose, a),
                                            CenteredMotion (RigidPose(), b)};
  const SegmentLink link{0, 1, 0.5 * (a + b), 0.5 * (a - b).norm()};
  const double scale = 0.7;
  const SeamCost cost (motions, link, 0.25, scale);
  std::array<double, 6> first{0.1, -0.2, 0.15, 0.05, 0.02, -0.03};
  std::array<double, 6> second{-0.3, 0.1, 0.2, -0.01, 0.04, 0.06};
  std::array<double*, 2> steps{first.data(), second.data()};
  std::array<double, 12> r{};
  std::array<double, 72> j0{};
  std::array<double, 72> j1{};
  std::array<double*, 2> jacobians{j0.data(), j1.data()};
  ASSERT_TRUE (cost.Evaluate (steps.data(), r.data(), jacobians.data()));
  for (int block = 0; block < 2; ++block)
    for (int c = 0; c < 6; ++c) {
      constexpr double h = 1e-6;
      std::array<double, 12> up{};
      std::array<double, 12> down{};
      const double kept = steps[block][c];
      steps[block][c] = kept + h;
      cost.Evaluate (steps.data(), up.data(), nullptr);
      steps[block][c] = kept - h;
      cost.Evaluate (steps.data(), down.data(), nullptr);
      steps[block][c] = kept;
      for (int k = 0; k < 12; ++k)
        EXPECT_NEAR (jacobians[block][6 * k + c], (up[k] - down[k]) / (2.0 * h), 1e-6)
            << block << " " << k << " " << c;
    }
}

TEST (SeamCost, OneMotionTearsNothing)
{
  const Eigen::Vector3d a (0.1, 0.2, 0.3);
  const Eigen::Vector3d b (0.5, 0.1, 0.2);
  const SegmentLink link{0, 1, 0.5 * (a + b), 0.5 * (a - b).norm()};
  EXPECT_NEAR (
      seamDifference (CenteredMotion (kPose, a), CenteredMotion (kPose, b), link, 0.1)
          .norm(),
      0.0,
      1e-12);
}

/** Points of a bent sheet, pulled to where a pose takes them. */
RigidMoments
momentsOf (const RigidPose& pose, double offset)
{
  RigidMoments moments;
  const Eigen::Matrix3d r = pose.rotation();
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d p (
        offset + 0.1 * std::cos (1.7 * i), 0.1 * std::sin (2.3 * i), 0.02 * (i % 7));
    const Eigen::Vector3d n =
        Eigen::Vector3d (std::sin (i), std::cos (2.0 * i), 1.0).normalized();
    PointPull pull;
    pull.add (pose * p, r * n, 1.0, 0.0);
    moments.add (p, pull, 1.0);
  }
  return moments;
}

TEST (RigidMoments, FindThePoseThatPullsFrom)
{
  const RigidMoments moments = momentsOf (kPose, 0.3);
  EXPECT_NEAR (moments.cost (kPose), 0.0, 1e-12);
  EXPECT_GT (moments.cost (RigidPose()), 1e-3);
  RigidPose start = kPose;
  start.parameters[0] += 0.2;
  start.parameters[4] -= 0.1;
  Matrix6 information;
  const RigidPose found = moments.solve (start, &information);
  EXPECT_THAT (found, test::isNear (kPose, 1e-7, 1e-7));
  // 1/2 x' information x is how the cost grows.
  RigidPose off = kPose;
  Vector6 x;
  x << 1e-4, -2e-4, 1e-4, 3e-4, -1e-4, 2e-4;
  for (int k = 0; k < 6; ++k)
    off.parameters[k] += x[k];
  EXPECT_NEAR (moments.cost (off) / (0.5 * x.dot (information * x)), 1.0, 1e-2);
}

/** Points at nearly one place, faintly pulled to others. */
RigidMoments
faintMoments (unsigned seed)
{
  std::mt19937 random (seed);
  const auto uniform = [&random] { return random() / 4294967296.0 - 0.5; };
  const auto anywhere = [&uniform] {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k)
      p[k] = uniform();
    return p;
  };
  RigidMoments moments;
  for (int i = 0; i < 3; ++i) {
    PointPull pull;
    const Eigen::Vector3d normal = anywhere().normalized();
    pull.add (anywhere(), normal, 1e-9, 0.01);
    moments.add (Eigen::Vector3d (0.5, -0.6, 0.1) + 1e-3 * anywhere(), pull, 1.0);
  }
  return moments;
}

TEST (RigidMoments, AreNotLostWhereFewPullsLeaveTurnsFree)
{
  for (unsigned seed = 0; seed < 200; ++seed) {
    const RigidMoments moments = faintMoments (seed);
    const RigidPose found = moments.solve (RigidPose());
    EXPECT_LE (moments.cost (found), moments.cost (RigidPose())) << seed;
    EXPECT_LT (found.translation().norm(), 5.0) << seed;
  }
}

/** Four segments of a bent sheet, the last two of which move otherwise. */
MergeView
bentView (const RigidPose& front, const RigidPose& back, double variance)
{
  MergeView view;
  view.poses = {front, front, back, back};
  view.variance = variance;
  for (int k = 0; k < 4; ++k)
    view.moments.push_back (momentsOf (view.poses[k], 0.2 * k));
  return view;
}

const std::vector<SegmentLink> kRow{{0, 1, Eigen::Vector3d::Zero(), 0.1},
                                    {1, 2, Eigen::Vector3d::Zero(), 0.1},
                                    {2, 3, Eigen::Vector3d::Zero(), 0.1}};

TEST (PartMerging, JoinsWhatMovesAsOneAndNoMore)
{
  RigidPose other = kPose;
  other.parameters[1] += 0.1;
  const MergedParts parts = mergeParts ({bentView (kPose, other, 1e-6)}, kRow, {});
  EXPECT_EQ (parts.part_of, (std::vector<int>{0, 0, 1, 1}));
  EXPECT_THAT (parts.poses[0][1], test::isNear (other, 1e-6, 1e-6));
  const MergedParts one = mergeParts ({bentView (kPose, other, 1.0)}, kRow, {});
  EXPECT_EQ (one.poses[0].size(), 1u);
}

TEST (PartMerging, PartsMoveAsOneInEveryTarget)
{
  RigidPose other = kPose;
  other.parameters[1] += 0.1;
  const MergeView still = bentView (kPose, kPose, 1e-6);
  const MergeView bent = bentView (kPose, other, 1e-6);
  EXPECT_EQ (mergeParts ({still, still}, kRow, {}).poses[1].size(), 1u);
  for (const auto& views : {std::vector<MergeView>{still, bent},
                            std::vector<MergeView>{bent, still, still}}) {
    const MergedParts parts = mergeParts (views, kRow, {});
    EXPECT_EQ (parts.part_of, (std::vector<int>{0, 0, 1, 1}));
    EXPECT_THAT (parts.poses[views.size() == 2 ? 0 : 1][1],
                 test::isNear (kPose, 1e-6, 1e-6));
  }
}

TEST (PartSeams, HoldABodyAlongTheDirectionThatItsSidesLeaveFree)
{
  // The sides of a square tube along x: they see its shift across, not along.
  RigidMoments tube;
  for (int i = 0; i < 80; ++i) {
    const Eigen::Vector3d n =
        (i % 2 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ()) *
        (i % 4 < 2 ? 1 : -1);
    const Eigen::Vector3d p = 0.1 * n + Eigen::Vector3d (0.01 * i, 0.0, 0.0);
    PointPull pull;
    pull.add (p + Eigen::Vector3d (0.0, 0.002, 0.0), n, 1.0, 0.0);
    tube.add (p, pull, 1.0);
  }
  RigidPose other; // of a body that moved along and, torn at the seam, far across
  other.parameters = {0.0, 0.0, 0.0, 0.03, 0.5, 0.0};
  const RigidMoments end = momentsOf (other, 0.3);
  SurfaceSeam seam;
  seam.second = 1;
  seam.center = Eigen::Vector3d (0.8, 0.0, 0.0);
  seam.edges = 50;
  std::vector<RigidMoments> moments{tube, end};
  const Surface none; // tells no cross-section
  holdSeams ({none, {}, {seam}}, {RigidPose(), other}, {}, moments);
  const RigidPose held = moments[0].solve (RigidPose());
  EXPECT_NEAR (held.parameters[3], 0.03, 1e-6);
  EXPECT_NEAR (held.parameters[4], 0.002, 1e-6);
  EXPECT_NEAR (tube.solve (RigidPose()).parameters[3], 0.0, 1e-6);
  EXPECT_EQ (moments[1].cost (RigidPose()), end.cost (RigidPose())); // is not free
}

TEST (SegmentStart, PairsThatAreWrongDoNotTurnIt)
{
  Eigen::Matrix3Xd from = Eigen::Matrix3Xd::Random (3, 40);
  Eigen::Matrix3Xd to (3, 40);
  for (int i = 0; i < 40; ++i)
    to.col (i) = kPose * Eigen::Vector3d (from.col (i));
  for (int i = 0; i < 8; ++i)
    to.col (i) += Eigen::Vector3d (1.0, 0.5, -0.7);
  const RigidPose found = fitPairs (from, to, std::vector<double> (40, 1.0), 0.05, {});
  EXPECT_THAT (found, test::isNear (kPose, 1e-3, 1e-3));
}

TEST (CloudJoints, FindTheAxisOfATurn)
{
  const Eigen::Vector3d axis = Eigen::Vector3d (0.2, -0.5, 1.0).normalized();
  const Eigen::Vector3d point (0.4, 0.1, -0.2);
  const Eigen::Matrix3d turn = rotationFromVector (0.35 * axis);
  CloudPart parent;
  CloudPart child;
  parent.target_from_source = kPose;
  child.target_from_source = kPose * RigidPose::fromMatrix (turn, point - turn * point);
  parent.information.setIdentity();
  child.information.setIdentity();
  parent.information *= 1e8;
  child.information *= 1e8;
  const Eigen::Vector3d seam (0.45, 0.15, -0.1);
  const CloudJoint joint = jointBetween (parent, child, seam);
  EXPECT_NEAR (joint.angle, 0.35, 1e-9);
  EXPECT_NEAR (joint.axis.dot (axis), 1.0, 1e-9);
  EXPECT_NEAR ((joint.point - point).cross (axis).norm(), 0.0, 1e-9);
  EXPECT_NEAR ((joint.point - seam).dot (axis), 0.0, 1e-9);
  EXPECT_NEAR (joint.shift, 0.0, 1e-9);
  EXPECT_GT (joint.angle_deviation, 0.0);
  EXPECT_LT (joint.angle_deviation, 1e-3);
}

} // namespace
