// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/result/common_errors.h"
#include "core/result/deviations.h"
#include "core/result/pose_covariance.h"
#include "support/points.h"
#include "support/two_bodies.h"

#include <cmath>
#include <random>

namespace {

using namespace pcl_msf;

const RigidPose kPose{{0.02, -0.03, 0.05, 0.1, -0.05, 0.08}};

TEST (Confidence, PointsFollowPosesAsFiniteDifferencesSay)
{
  const Eigen::Vector3d point (0.4, -0.3, 1.7);
  const Eigen::Matrix<double, 3, 6> j =
      pointJacobian (leftJacobian ({0.02, -0.03, 0.05}), kPose.rotation() * point);
  for (int i = 0; i < 6; ++i) {
    RigidPose less = kPose, more = kPose;
    less.parameters[i] -= 1e-6;
    more.parameters[i] += 1e-6;
    const Eigen::Vector3d slope = (more * point - less * point) / 2e-6;
    EXPECT_LT ((slope - j.col (i)).norm(), 1e-7) << i;
  }
}

/** One segment of a few points, known motion, an image of one row. */
class FewPoints {
public:
  FewPoints()
  {
    const std::vector<Eigen::Vector3f> points{
        {0.0f, 0.0f, 1.0f}, {0.4f, -0.3f, 1.7f}, {-0.5f, 0.2f, 3.0f}};
    pixels_.begin = {0, 3};
    pixels_.centroid = {{0.0, 0.0, 2.0}};
    scene_.labels = cv::Mat (1, 3, CV_32SC1, cv::Scalar (0));
    scene_.displacement.create (1, 3, CV_32FC3);
    scene_.flow = cv::Mat (1, 3, CV_32FC2, cv::Scalar (1, 2));
    scene_.visibility =
        cv::Mat (1, 3, CV_8UC1, cv::Scalar (pixelValue (Visibility::Visible)));
    for (int i = 0; i < 3; ++i) {
      pixels_.pixel.push_back (i);
      pixels_.x.push_back (points[i].x());
      pixels_.y.push_back (points[i].y());
      pixels_.z.push_back (points[i].z());
      scene_.displacement.at<cv::Vec3f> (0, i) = {0.1f, 0.0f, 0.0f};
    }
    scene_.segments.resize (1);
    scene_.segments[0].current_from_reference = kPose;
    tuning_.across = tuning_.across_unseen = 0.0;
    tuning_.near_step = tuning_.far_step = 1;
  }

  const SceneFlow&
  filled (const Matrix6& covariance,
          double inverse_depth_noise,
          InstructionSet set = chosenInstructionSet())
  {
    fillDeviations (
        pixels_, {covariance}, camera_, inverse_depth_noise, tuning_, 1, scene_, set);
    return scene_;
  }

  const PinholeCamera camera_{400.0, 420.0, 160.0, 120.0};
  SegmentPixels pixels_;
  SceneFlow scene_;
  DeviationTuning tuning_;
};

TEST (Confidence, AllInstructionSetsGiveTheSameBits)
{
  Matrix6 covariance = 1e-6 * Matrix6::Identity();
  covariance (0, 4) = covariance (4, 0) = 5e-7;
  FewPoints few;
  for (int i = 0; i < 300; ++i) { // more of the same image's points, none of them new
    few.pixels_.pixel.push_back (i % 3);
    few.pixels_.x.push_back (0.013f * static_cast<float> (i % 37));
    few.pixels_.y.push_back (-0.007f * static_cast<float> (i % 53));
    few.pixels_.z.push_back (1.0f + 0.01f * static_cast<float> (i));
  }
  few.pixels_.begin = {0, 303};
  few.filled (covariance, 0.004, InstructionSet::Default);
  const cv::Mat flow = few.scene_.flow_deviation.clone();
  const cv::Mat displacement = few.scene_.displacement_deviation.clone();
  for (const InstructionSet set : usableInstructionSets()) {
    few.filled (covariance, 0.004, set);
    EXPECT_EQ (cv::norm (few.scene_.flow_deviation, flow, cv::NORM_INF), 0.0);
    EXPECT_EQ (cv::norm (few.scene_.displacement_deviation, displacement, cv::NORM_INF),
               0.0);
  }
}

TEST (Confidence, DeviationsAreThoseOfRandomPosesAndDepths)
{
  FewPoints few;
  std::mt19937 random (3);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd root (6, 6); // of a covariance with all correlations
  for (int i = 0; i < 36; ++i)
    root.data()[i] = 1e-3 * normal (random);
  const Matrix6 covariance = root * root.transpose();
  const double noise = 0.004;
  const SceneFlow& scene = few.filled (covariance, noise);
  constexpr int kDraws = 20000;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d point (few.pixels_.x[i], few.pixels_.y[i], few.pixels_.z[i]);
    const Eigen::Vector3d way = kPose * point - point;
    double flow = 0.0, displacement = 0.0;
    for (int draw = 0; draw < kDraws; ++draw) {
      Eigen::VectorXd by (6);
      for (int k = 0; k < 6; ++k)
        by[k] = normal (random);
      const Eigen::VectorXd error = root * by;
      RigidPose pose = kPose;
      for (int k = 0; k < 6; ++k)
        pose.parameters[k] += error[k];
      const Eigen::Vector3d other =
          point / (1.0 + point.z() * noise * normal (random)); // along the ray
      const Eigen::Vector3d moved = pose * other;
      flow += (few.camera_.project (moved) - few.camera_.project (kPose * point))
                  .squaredNorm();
      displacement += (moved - other - way).squaredNorm();
    }
    EXPECT_NEAR (
        scene.flow_deviation.at<float> (0, i) / std::sqrt (flow / kDraws), 1.0, 0.03);
    EXPECT_NEAR (scene.displacement_deviation.at<float> (0, i) /
                     std::sqrt (displacement / kDraws),
                 1.0,
                 0.03);
  }
}

TEST (Confidence, UnknownMotionHasNone)
{
  FewPoints few;
  few.scene_.displacement.at<cv::Vec3f> (0, 1) = cv::Vec3f::all (std::nanf (""));
  few.scene_.flow.at<cv::Vec2f> (0, 1) = cv::Vec2f::all (std::nanf (""));
  const SceneFlow& scene = few.filled (Matrix6::Identity(), 0.0);
  EXPECT_TRUE (std::isnan (scene.flow_deviation.at<float> (0, 1)));
  EXPECT_TRUE (std::isnan (scene.displacement_deviation.at<float> (0, 1)));
  EXPECT_GT (scene.flow_deviation.at<float> (0, 2), 0.0f);
}

TEST (Confidence, StepsInMotionAreDoubtfulMostWhereNothingIsSeen)
{
  FewPoints few;
  few.tuning_.across = 0.04;
  few.tuning_.across_unseen = 1.0;
  few.scene_.segments.resize (2); // the second has another motion
  few.scene_.labels.at<int> (0, 2) = 1;
  few.scene_.flow.at<cv::Vec2f> (0, 2) = {6.0f, 2.0f}; // 5 px from the others
  few.scene_.visibility.at<unsigned char> (0, 2) = pixelValue (Visibility::Occluded);
  const SceneFlow& scene = few.filled (1e-18 * Matrix6::Identity(), 0.0);
  EXPECT_LT (scene.flow_deviation.at<float> (0, 0), 0.01f);
  // One of two neighbours differs; the only one does.
  EXPECT_NEAR (scene.flow_deviation.at<float> (0, 1), 0.2 * 5.0 / std::sqrt (2.0), .01);
  EXPECT_NEAR (scene.flow_deviation.at<float> (0, 2), 5.0, 0.01);
}

/** Information of a wall at rest, cut into tiles, with depth noise that is the same all
 * over squares. */
BodyInformation
wallWithNoise (int side)
{
  constexpr int kWidth = 320, kHeight = 240, kTile = 20;
  std::mt19937 random (7);
  std::normal_distribution<float> normal (0.0f, 0.001f); // 1 / metres
  cv::Mat blocks (kHeight / side + 1, kWidth / side + 1, CV_32FC1);
  for (auto value = blocks.begin<float>(); value != blocks.end<float>(); ++value)
    *value = normal (random);
  FrameLevel level;
  level.camera = {300.0, 300.0, 159.5, 119.5};
  level.inverse_depth = cv::Mat (kHeight, kWidth, CV_32FC1, cv::Scalar (0.5));
  level.normals = cv::Mat (kHeight, kWidth, CV_32FC3, cv::Scalar (0, 0, -1));
  level.intensity = test::image (kWidth, kHeight, [] (int x, int y) {
    return 0.5 + 0.2 * std::sin (0.3 * x) * std::cos (0.25 * y);
  });
  cv::Mat labels (kHeight, kWidth, CV_32SC1);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      labels.at<int> (y, x) = y / kTile * (kWidth / kTile) + x / kTile;
  const int segments = kWidth / kTile * (kHeight / kTile);
  NoiseModel noise;
  noise.intensity = 0.004;
  noise.displacement = 0.0;
  noise.inverse_depth = 0.001;
  const SegmentPixels pixels = test::pointsOf (level, labels, segments, noise, 0.01);
  level.inverse_depth += test::image (kWidth, kHeight, [&] (int x, int y) {
    return blocks.at<float> (y / side, x / side);
  });
  const Texture texture (level);
  MotionState state;
  state.body_of.assign (segments, 0);
  state.poses.resize (1);
  DataTerm data (pixels, texture, makeRules ({}, pixels, {}), 1);
  data.sweep (state, DataTerm::Pass::Linearize);
  return informationOfBodies (data, state, residualScale ({}, pixels), {})[0];
}

TEST (Confidence, WhatResidualsShareOverABodyCountsOnce)
{
  const double alone = wallWithNoise (1).excess;
  const double shared = wallWithNoise (16).excess;
  EXPECT_LT (alone, 8.0);
  EXPECT_GT (shared, 4.0 * alone);
}

/** Poses of a solved scene of two bodies, with all that fillInformation needs. */
SceneFlow
informed (const test::TiledScene& scene, const MotionState& state, int threads = 1)
{
  DataTerm data = scene.data();
  data.sweep (state, DataTerm::Pass::Linearize);
  SceneFlow result;
  result.segments.resize (state.body_of.size());
  for (std::size_t k = 0; k < result.segments.size(); ++k) {
    SegmentMotion& segment = result.segments[k];
    segment.current_from_reference = state.poseOf (static_cast<int> (k));
    segment.status = MotionStatus::Determined;
    segment.points = data.pixels().size (static_cast<int> (k));
    segment.visible_points = segment.points;
    segment.group = state.body_of[k];
  }
  result.groups = static_cast<int> (state.poses.size());
  fillInformation (
      data, scene.links(), state, scene.residualScale(), {}, threads, result);
  return result;
}

TEST (Confidence, EverySegmentAndGroupHasInformationTheSameForAnyThreads)
{
  const test::TiledScene scene (test::foldedWall());
  const MotionState state = scene.solved();
  const SceneFlow one = informed (scene, state);
  const SceneFlow more = informed (scene, state, 3);
  ASSERT_EQ (one.group_motions.size(), 2U);
  int segments = 0;
  for (const GroupMotion& group : one.group_motions)
    segments += group.segments;
  EXPECT_EQ (segments, static_cast<int> (one.segments.size()));
  for (std::size_t k = 0; k < one.segments.size(); ++k) {
    EXPECT_EQ (one.segments[k].information, more.segments[k].information);
    const GroupMotion& group = one.group_motions[one.segments[k].group];
    EXPECT_EQ (group.current_from_reference.parameters,
               one.segments[k].current_from_reference.parameters);
    for (int i = 0; i < 6; ++i) {
      EXPECT_GT (one.segments[k].information (i, i), 0.0);
      EXPECT_GT (group.information (i, i), 0.0);
    }
  }
}

TEST (Confidence, ASegmentThatIsNotFoundIsLessSure)
{
  const test::TiledScene scene (test::foldedWall());
  const MotionState state = scene.solved();
  DataTerm data = scene.data();
  data.sweep (state, DataTerm::Pass::Linearize);
  SceneFlow result = informed (scene, state);
  constexpr int kBeside = 3; // the other body
  const double sure = result.segments[kBeside].information.trace();
  result.segments[kBeside].visible_points = 0;
  result.segments[1].status = MotionStatus::Undetermined;
  const std::vector<Matrix6> covariances = fillInformation (
      data, scene.links(), state, scene.residualScale(), {}, 1, result);
  EXPECT_LT (result.segments[kBeside].information.trace(), 0.1 * sure);
  EXPECT_EQ (result.segments[1].information.norm(), 0.0);
  EXPECT_TRUE (std::isnan (covariances[1](0, 0)));
}

} // namespace
