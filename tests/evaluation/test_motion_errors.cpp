// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/pose_matcher.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/evaluation/motion_errors.h>
#include <pcl_msf/evaluation/trajectory_errors.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::evaluation;

constexpr double kDegree = M_PI / 180.0;

RigidPose
pose (const Eigen::Vector3d& rotation, const Eigen::Vector3d& translation)
{
  RigidPose p;
  for (int i = 0; i < 3; ++i) {
    p.parameters[i] = rotation[i];
    p.parameters[i + 3] = translation[i];
  }
  return p;
}

cv::Mat
partition (const std::vector<int>& sets)
{
  return cv::Mat (sets, true).reshape (1, 1);
}

double
index (const std::vector<int>& a, const std::vector<int>& b)
{
  return adjustedRandIndex (partition (a), partition (b));
}

TEST (AdjustedRandIndex, PublishedExamples)
{
  // Yeung and Ruzzo's supplement to Bioinformatics 17 (2001): ten objects, sets of
  // 2, 4, 4 against 2, 3, 5, contingency 1 1 0 / 1 2 1 / 0 0 4: 0.313.
  EXPECT_NEAR (index ({0, 0, 1, 1, 1, 1, 2, 2, 2, 2}, {0, 1, 0, 1, 1, 2, 2, 2, 2, 2}),
               (7.0 - 13.0 * 14.0 / 45.0) / (13.5 - 13.0 * 14.0 / 45.0),
               1e-12);
  EXPECT_NEAR (index ({0, 0, 1, 1}, {0, 0, 1, 2}), 0.5714285714, 1e-9);
  EXPECT_NEAR (index ({0, 0, 1, 1}, {0, 1, 0, 1}), -0.5, 1e-12);
  EXPECT_NEAR (index ({0, 0, 0, 0}, {0, 1, 2, 3}), 0.0, 1e-12);
}

TEST (AdjustedRandIndex, NamesDoNotMatterAndEqualPartitionsScoreOne)
{
  EXPECT_DOUBLE_EQ (index ({0, 0, 1, 1}, {7, 7, 3, 3}), 1.0);
  EXPECT_DOUBLE_EQ (index ({5, 5, 5}, {0, 0, 0}), 1.0);
  EXPECT_DOUBLE_EQ (index ({0, 1, 2}, {2, 1, 0}), 1.0);
}

TEST (AdjustedRandIndex, PixelsWithoutLabelAreLeftOut)
{
  EXPECT_DOUBLE_EQ (index ({0, 0, 1, 1, 0}, {0, 0, 1, 1, -1}), 1.0);
  EXPECT_TRUE (std::isnan (index ({-1, 0}, {0, 0})));
  EXPECT_THROW (index ({0, 0}, {0, 0, 0}), InvalidInput);
}

TEST (GroupPurity, FallsWhenBodiesAreMergedNotWhenTheyAreSplit)
{
  const cv::Mat labels = partition ({0, 0, 0, 1, 1, 1});
  EXPECT_DOUBLE_EQ (groupPurity (partition ({0, 1, 2, 3, 4, 5}), labels), 1.0);
  EXPECT_DOUBLE_EQ (groupPurity (partition ({0, 0, 0, 0, 1, 1}), labels), 5.0 / 6.0);
  EXPECT_DOUBLE_EQ (groupPurity (partition ({0, 0, 0, 0, 0, 0}), labels), 0.5);
}

TEST (PoseError, AngleAndDisplacementAtThePoint)
{
  const RigidPose truth = pose ({0, 0, 30 * kDegree}, {1, 0, 0});
  const RigidPose estimate = pose ({0, 0, 33 * kDegree}, {1, 0.004, 0});
  const PoseError e = poseError (estimate, truth);
  EXPECT_NEAR (e.rotation_deg, 3.0, 1e-9);
  EXPECT_NEAR (e.translation_mm, 4.0, 1e-9);
  // A rotation about the point itself does not move it.
  const Eigen::Vector3d center (0, 0, 2);
  const RigidPose turn = pose ({0, 2 * kDegree, 0}, {0, 0, 0});
  const RigidPose about_center =
      pose ({0, 2 * kDegree, 0}, center - turn.rotation() * center);
  EXPECT_NEAR (poseError (about_center, {}, center).translation_mm, 0.0, 1e-9);
  EXPECT_NEAR (poseError (about_center, {}).translation_mm,
               2000.0 * 2 * std::sin (1 * kDegree),
               1e-9);
}

/** Two segments of 3 and 1 points; bodies 0 (moves by x = 1) and 1 (soft). */
SceneFlow
twoSegments ()
{
  SceneFlow flow;
  flow.labels = partition ({0, 0, 0, 1});
  flow.segments.resize (2);
  flow.segments[0].points = 3;
  flow.segments[1].points = 1;
  for (SegmentMotion& s : flow.segments)
    s.status = MotionStatus::Determined;
  flow.segments[0].current_from_reference = pose ({0, 0, 0}, {1.002, 0, 0});
  flow.segments[1].current_from_reference = pose ({0, 0, kDegree}, {1, 0, 0.006});
  return flow;
}

TEST (SegmentErrors, MeansAreWeightedByPoints)
{
  const auto e = segmentErrors (
      twoSegments(), partition ({0, 0, 1, 0}), {pose ({0, 0, 0}, {1, 0, 0}), {}});
  EXPECT_EQ (e.segments, 2);
  EXPECT_NEAR (e.translation_mm, (3 * 2.0 + 6.0) / 4, 1e-9);
  EXPECT_NEAR (e.rotation_deg, 0.25, 1e-9);
  EXPECT_NEAR (e.median_translation_mm, 4.0, 1e-9);
  EXPECT_NEAR (e.median_rotation_deg, 0.5, 1e-9);
}

TEST (SegmentErrors, AreHeldAgainstTheirInformation)
{
  SceneFlow flow = twoSegments();
  flow.segments[0].information (3, 3) = 1e6; // known to a millimetre, off by two
  flow.segments[1].information (5, 5) = 1e6; // off by six
  const std::vector<std::optional<RigidPose>> bodies{pose ({0, 0, 0}, {1, 0, 0})};
  const cv::Mat labels = partition ({0, 0, 0, 0});
  const auto both = segmentErrors (flow, labels, bodies);
  EXPECT_NEAR (both.normalized_square, (4.0 + 36.0) / 2, 1e-6);
  EXPECT_NEAR (both.median_normalized_square, 20.0, 1e-6);
  flow.segments[1].status = MotionStatus::Supported; // by others, not by its own points
  EXPECT_NEAR (segmentErrors (flow, labels, bodies).normalized_square, 4.0, 1e-6);
  flow.segments[0].status = MotionStatus::Supported;
  EXPECT_TRUE (std::isnan (segmentErrors (flow, labels, bodies).normalized_square));
}

TEST (SegmentErrors, GroupsAreHeldAgainstTheBodyOfMostOfTheirPoints)
{
  SceneFlow flow = twoSegments();
  flow.group_motions.resize (1);
  flow.segments[0].group = flow.segments[1].group = 0;
  flow.group_motions[0].current_from_reference =
      flow.segments[0].current_from_reference;
  flow.group_motions[0].information (3, 3) = 1e6; // off by two millimetres
  const std::vector<std::optional<RigidPose>> bodies{pose ({0, 0, 0}, {1, 0, 0}), {}};
  const cv::Mat labels = partition ({0, 0, 0, 1}); // the soft one has fewer points
  EXPECT_NEAR (
      segmentErrors (flow, labels, bodies).groups_normalized_square, 4.0, 1e-6);
  flow.segments[0].status = flow.segments[1].status = MotionStatus::Supported;
  EXPECT_TRUE (
      std::isnan (segmentErrors (flow, labels, bodies).groups_normalized_square));
}

TEST (SegmentErrors, SoftAndUnlabelledBodiesAreNotScored)
{
  const std::vector<std::optional<RigidPose>> bodies{pose ({0, 0, 0}, {1, 0, 0}), {}};
  EXPECT_EQ (segmentErrors (twoSegments(), partition ({0, 0, 0, 1}), bodies).segments,
             1);
  const auto none = segmentErrors (twoSegments(), partition ({-1, -1, -1, -1}), bodies);
  EXPECT_EQ (none.segments, 0);
  EXPECT_TRUE (std::isnan (none.rotation_deg));
}

TEST (SegmentErrors, UndeterminedSegmentsCountAsResting)
{
  SceneFlow flow = twoSegments();
  flow.segments[0].status = MotionStatus::Undetermined;
  flow.segments[0].current_from_reference = pose ({0, 0, 0}, {1, 0, 0});
  const auto e =
      segmentErrors (flow, partition ({0, 0, 0, -1}), {pose ({0, 0, 0}, {1, 0, 0})});
  EXPECT_NEAR (e.translation_mm, 1000.0, 1e-9);
}

TEST (MotionGroups, EachPixelHasItsSegmentsGroup)
{
  SceneFlow flow = twoSegments();
  flow.labels = partition ({-1, 1, 0, 1});
  flow.segments[0].group = 4;
  flow.segments[1].group = 2;
  const cv::Mat groups = motionGroups (flow);
  EXPECT_EQ (cv::countNonZero (groups != partition ({-1, 2, 4, 2})), 0);
}

TEST (FitSegments, RecoversRigidMotionsAndFallsBack)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const RigidPose truth = pose ({0.1, -0.2, 0.3}, {0.5, 0.1, -0.2});
  const std::vector<cv::Vec3f> points{
      {0, 0, 1}, {1, 0, 1}, {0, 1, 2}, {1, 1, 3}, {0, 0, 1}, {2, 2, 2}, {nan, 0, 0}};
  std::vector<cv::Vec3f> flow;
  for (const cv::Vec3f& p : points) {
    const Eigen::Vector3d from (p[0], p[1], p[2]);
    const Eigen::Vector3f d = (truth * from - from).cast<float>();
    flow.emplace_back (d.x(), d.y(), d.z());
  }
  flow[4] = {0, 0, 4};
  flow[5] = {0, 0, 2};
  const cv::Mat labels = partition ({0, 0, 0, 0, 1, 1, 2});
  const auto poses = fitSegments (labels,
                                  cv::Mat (points, true).reshape (3, 1),
                                  cv::Mat (flow, true).reshape (3, 1),
                                  3);
  ASSERT_EQ (poses.size(), 3u);
  EXPECT_THAT (poses[0], test::isNear (truth, 1e-6, 1e-6));
  EXPECT_NEAR (poses[1].angle(), 0.0, 1e-12); // two points: the mean translation
  EXPECT_NEAR (poses[1].translation().z(), 3.0, 1e-6);
  EXPECT_EQ (poses[2].parameters, RigidPose{}.parameters);
}

std::vector<RigidPose>
straightPath ()
{
  std::vector<RigidPose> path;
  for (int k = 0; k < 5; ++k)
    path.push_back (pose ({0, 0, 0}, {0.1 * k, 0.02 * k * k, 0}));
  return path;
}

TEST (TrajectoryErrors, AnotherWorldFrameIsNoError)
{
  const auto truth = straightPath();
  const RigidPose world = pose ({0.3, 0.2, -0.5}, {3, 2, 1});
  std::vector<RigidPose> estimate;
  for (const RigidPose& p : truth)
    estimate.push_back (world * p);
  EXPECT_NEAR (absoluteTrajectoryError (estimate, truth), 0.0, 1e-9);
  EXPECT_NEAR (relativePoseError (estimate, truth).translation, 0.0, 1e-9);
  EXPECT_NEAR (relativePoseError (estimate, truth).rotation_deg, 0.0, 1e-6);
}

TEST (TrajectoryErrors, AlignedDistancesByHand)
{
  // Positions -1, 0, 1 on a line against -2, 0, 2: aligned, each end is 1 m off.
  const auto line = [] (double length) {
    std::vector<RigidPose> path;
    for (const double x : {-length, 0.0, length})
      path.push_back (pose ({0, 0, 0}, {x, 0, 0}));
    return path;
  };
  EXPECT_NEAR (
      absoluteTrajectoryError (line (1), line (2)), std::sqrt (2.0 / 3.0), 1e-9);
}

TEST (TrajectoryErrors, DriftOverFramesByHand)
{
  const auto truth = straightPath();
  auto estimate = truth;
  // One step is 3 mm too long and turns by 2 deg: one of four steps, root mean square.
  for (std::size_t k = 3; k < estimate.size(); ++k)
    estimate[k] = truth[2] * pose ({0, 0, 2 * kDegree}, {0, 0, 0.003}) *
                  truth[2].inverse() * truth[k];
  const auto one = relativePoseError (estimate, truth, 1);
  EXPECT_NEAR (one.rotation_deg, 2.0 / std::sqrt (4.0), 1e-6);
  const auto two = relativePoseError (estimate, truth, 2);
  EXPECT_NEAR (two.rotation_deg, 2.0 * std::sqrt (2.0 / 3.0), 1e-6);
  EXPECT_TRUE (std::isnan (relativePoseError (estimate, truth, 5).translation));
  EXPECT_THROW (relativePoseError (estimate, truth, 0), InvalidInput);
  estimate.pop_back();
  EXPECT_THROW (absoluteTrajectoryError (estimate, truth), InvalidInput);
}

TEST (TrajectoryErrors, ChainedMotionsAreCameraPoses)
{
  const auto truth = straightPath();
  std::vector<RigidPose> motions;
  for (std::size_t k = 1; k < truth.size(); ++k)
    motions.push_back (truth[k].inverse() * truth[k - 1]);
  const auto path = chainMotions (motions);
  ASSERT_EQ (path.size(), truth.size());
  EXPECT_NEAR ((path[4].translation() - truth[4].translation()).norm(), 0.0, 1e-12);
}

} // namespace
