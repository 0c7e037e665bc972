// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/data_term.h"
#include "support/analytic_scene.h"
#include "support/points.h"

#include <cmath>
#include <memory>
#include <random>

namespace {

using namespace pcl_msf;
using Pass = DataTerm::Pass;

constexpr int kSize = 32;
constexpr double kFocal = 40.0;
constexpr int kU = 10;
constexpr int kV = 12;
const PinholeCamera kCamera{kFocal, kFocal, 15.5, 15.5};
constexpr double kSlopeU = 0.01; // of the intensity, per pixel
constexpr double kSlopeV = 0.005;

/** A wall at 2 m that faces the camera, its intensity linear in the image. */
FrameLevel
wall (double inverse_depth = 0.5)
{
  FrameLevel level;
  level.camera = kCamera;
  level.intensity = test::image (
      kSize, kSize, [] (int x, int y) { return 0.1 + kSlopeU * x + kSlopeV * y; });
  level.inverse_depth =
      test::image (kSize, kSize, [&] (int, int) { return inverse_depth; });
  level.normals = cv::Mat (kSize, kSize, CV_32FC3, cv::Scalar (0, 0, -1));
  return level;
}

/** A single point of the wall against some current frame. */
class OnePoint {
public:
  explicit OnePoint (const EnergyParameters& energy = {},
                     const FrameLevel& current = wall())
  {
    cv::Mat labels (kSize, kSize, CV_32SC1, cv::Scalar (-1));
    labels.at<int> (kV, kU) = 0;
    NoiseModel noise;
    noise.intensity = 0.02;
    noise.displacement = 0.0;
    noise.inverse_depth = 0.001;
    noise.relative_depth = 0.0;
    pixels_ = test::pointsOf (wall(), labels, 1, noise, 0.01);
    texture_ = std::make_unique<Texture> (current);
    data_ =
        std::make_unique<DataTerm> (pixels_, *texture_, makeRules (energy, pixels_), 1);
  }

  const SegmentQuadratic&
  shifted (double x, double y, double z)
  {
    RigidPose pose;
    pose.parameters = {0, 0, 0, x, y, z};
    data_->sweep (MotionState::fromSegments ({pose}, 0), Pass::Linearize);
    return data_->of (0);
  }

  int
  active () const
  {
    return data_->active()[0];
  }
  const kernel::Rules&
  rules () const
  {
    return data_->rules();
  }

private:
  SegmentPixels pixels_;
  std::unique_ptr<Texture> texture_;
  std::unique_ptr<DataTerm> data_;
};

EnergyParameters
squares ()
{
  EnergyParameters energy;
  energy.loss = LossType::L2;
  return energy;
}

TEST (DataTerm, BrightnessResidualByHand)
{
  // 0.1 m at 2 m are 2 pixels to the right, 0.05 m one pixel down.
  const double r = (2.0 * kSlopeU + 1.0 * kSlopeV) / 0.02;
  OnePoint point (squares());
  const SegmentQuadratic q = point.shifted (0.1, 0.05, 0.0);
  EXPECT_NEAR (q.brightness_cost, 0.5 * r * r, 1e-5);
  EXPECT_NEAR (q.icp_cost, 0.0, 1e-9);
  // d r / d t_x = slope * f / z / sigma.
  EXPECT_NEAR (q.gradient[3], r * kSlopeU * kFocal / 2.0 / 0.02, 1e-3);
  EXPECT_NEAR (q.gradient[4], r * kSlopeV * kFocal / 2.0 / 0.02, 1e-3);
}

TEST (DataTerm, PointToPlaneResidualByHand)
{
  // The depth noise is z^2 sigma_w = 4 mm: 2 mm are half a standard deviation.
  OnePoint point (squares());
  const SegmentQuadratic q = point.shifted (0.0, 0.0, 0.002);
  EXPECT_NEAR (q.icp_cost, 0.5 * 0.25, 1e-4);
  EXPECT_NEAR (q.information (5, 5), 250.0 * 250.0, 60.0); // the brightness adds a bit
  EXPECT_EQ (point.active(), kernel::kBrightness | kernel::kIcp);
}

TEST (DataTerm, TermsAreWeightedAndDividedByTheirCounts)
{
  EnergyParameters energy = squares();
  energy.brightness_weight = 3.0;
  energy.icp_weight = 0.5;
  SegmentPixels pixels;
  pixels.brightness_count = 6;
  pixels.icp_count = 4;
  const kernel::Rules rules = makeRules (energy, pixels);
  EXPECT_FLOAT_EQ (rules.brightness_weight, 0.5f);
  EXPECT_FLOAT_EQ (rules.icp_weight, 0.125f);
}

TEST (DataTerm, HuberBelowAtAndAboveTheThreshold)
{
  for (const double epsilon : {0.5, 1.0, 2.0}) {
    EnergyParameters energy;
    energy.huber_threshold = epsilon;
    OnePoint point (energy);
    for (const double share : {0.0, 0.5, 0.999, 1.0, 1.001, 1.5, -0.7, -1.8}) {
      const double r = share * epsilon;
      // r standard deviations to the right: r 0.02 / slope pixels.
      const double shift = r * 0.02 / kSlopeU * 2.0 / kFocal;
      const SegmentQuadratic q = point.shifted (shift, 0.0, 0.0);
      const bool small = std::abs (r) <= epsilon;
      const double cost =
          small ? 0.5 * r * r : epsilon * (std::abs (r) - 0.5 * epsilon);
      EXPECT_NEAR (q.brightness_cost, cost, 2e-5) << epsilon << " " << share;
      const double slope = small ? r : std::copysign (epsilon, r);
      EXPECT_NEAR (q.gradient[3], slope * kSlopeU * kFocal / 2.0 / 0.02, 1e-3);
    }
  }
}

TEST (DataTerm, ZeroThresholdIsTheAbsoluteValue)
{
  EnergyParameters zero;
  zero.huber_threshold = 0.0;
  EnergyParameters named;
  named.loss = LossType::L1;
  for (const EnergyParameters& energy : {zero, named}) {
    OnePoint point (energy);
    EXPECT_NEAR (point.shifted (0.1, 0.0, 0.0).brightness_cost, 1.0, 1e-3);
    EXPECT_NEAR (point.shifted (-0.2, 0.0, 0.0).brightness_cost, 2.0, 1e-3);
    EXPECT_NEAR (point.shifted (0.0, 0.0, 0.0).brightness_cost, 0.0, 1e-3);
  }
}

TEST (DataTerm, SquaresAreNotLimited)
{
  OnePoint point (squares());
  EXPECT_NEAR (point.shifted (0.4, 0.0, 0.0).brightness_cost, 0.5 * 16.0, 1e-4);
}

TEST (DataTerm, BehindTheSurfaceIsOccluded)
{
  OnePoint point ({}, wall (1.0));
  const SegmentQuadratic q = point.shifted (0.0, 0.0, 0.0);
  EXPECT_EQ (point.active(), kernel::kOccluded);
  EXPECT_FLOAT_EQ (q.brightness_cost, point.rules().occluded_cost);
  EXPECT_FLOAT_EQ (q.icp_cost, point.rules().occluded_cost);
  EXPECT_EQ (q.information.norm(), 0.0);
}

TEST (DataTerm, FarBeforeTheSurfaceIsAConflict)
{
  OnePoint point ({}, wall (0.2));
  const SegmentQuadratic q = point.shifted (0.0, 0.0, 0.0);
  EXPECT_EQ (point.active(), kernel::kBrightness);
  EXPECT_NEAR (q.brightness_cost, 0.0, 1e-9);
  EXPECT_FLOAT_EQ (q.icp_cost, point.rules().conflict_cost);
}

TEST (DataTerm, HoleKeepsTheBrightness)
{
  OnePoint point ({}, wall (0.0));
  const SegmentQuadratic q = point.shifted (0.1, 0.0, 0.0);
  EXPECT_EQ (point.active(), kernel::kBrightness | kernel::kUnknown);
  EXPECT_GT (q.brightness_cost, 0.1);
  EXPECT_FLOAT_EQ (q.icp_cost, point.rules().unknown_cost);
}

TEST (DataTerm, OutOfViewOnEverySideAndBehindTheCamera)
{
  OnePoint point;
  for (const Eigen::Vector3d& t : {Eigen::Vector3d (5, 0, 0),
                                   Eigen::Vector3d (-5, 0, 0),
                                   Eigen::Vector3d (0, 5, 0),
                                   Eigen::Vector3d (0, -5, 0),
                                   Eigen::Vector3d (0, 0, -2.5)}) {
    const SegmentQuadratic q = point.shifted (t.x(), t.y(), t.z());
    EXPECT_EQ (point.active(), kernel::kOutside) << t.transpose();
    EXPECT_FLOAT_EQ (q.brightness_cost, point.rules().outside_cost);
    EXPECT_FLOAT_EQ (q.icp_cost, point.rules().outside_cost);
    EXPECT_EQ (q.gradient.norm(), 0.0);
  }
}

TEST (DataTerm, HidingIsNotFree)
{
  const kernel::Rules rules = OnePoint().rules();
  for (const float cost : {rules.conflict_cost,
                           rules.occluded_cost,
                           rules.outside_cost,
                           rules.unknown_cost})
    EXPECT_GT (cost, 1.0f); // of a residual of more than one standard deviation
}

/** A bumpy, textured patch that fills the image, as reference and current. */
FrameLevel
bumps (double phase)
{
  FrameLevel level;
  level.camera = kCamera;
  level.intensity = test::image (kSize, kSize, [&] (int x, int y) {
    return test::texture (0.03 * x, 0.03 * y, phase);
  });
  level.inverse_depth = test::image (kSize, kSize, [&] (int x, int y) {
    return 0.5 + 0.01 * std::sin (0.3 * x + phase) + 0.008 * std::cos (0.25 * y);
  });
  level.normals = cv::Mat (kSize, kSize, CV_32FC3);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      level.normals.at<cv::Vec3f> (y, x) = cv::normalize (
          cv::Vec3f (0.3f * std::sin (0.4f * x), 0.3f * std::cos (0.3f * y), -1.0f));
  return level;
}

class Gradient : public testing::TestWithParam<double> {};

TEST_P (Gradient, MatchesCentralDifferencesOfTheKeptCost)
{
  std::mt19937 generator (11);
  std::uniform_real_distribution<double> uniform (-1.0, 1.0);
  cv::Mat labels (kSize, kSize, CV_32SC1, cv::Scalar (-1));
  labels (cv::Rect (13, 12, 6, 7)) = 0;
  const SegmentPixels pixels =
      test::pointsOf (bumps (0.3), labels, 1, NoiseModel{}, 0.4);
  const Texture texture (bumps (0.9));
  DataTerm data (pixels, texture, makeRules ({}, pixels), 1);
  data.setDoublePrecision (true);
  for (int trial = 0; trial < 10; ++trial) {
    const Eigen::Vector3d axis =
        Eigen::Vector3d (uniform (generator), uniform (generator), uniform (generator))
            .normalized();
    const Eigen::Vector3d shift (
        0.2 * uniform (generator), 0.2 * uniform (generator), 0.02);
    MotionState state = MotionState::fromSegments (
        {test::turnAbout (pixels.centroid[0], GetParam() * axis, shift)}, 0);
    data.sweep (state, Pass::Linearize);
    int seen = 0;
    for (const int active : data.active())
      seen += (active & kernel::kIcp) ? 1 : 0;
    ASSERT_GT (seen, 20);
    data.sweep (state, Pass::LinearizeKept);
    const SegmentQuadratic q = data.of (0);
    for (int i = 0; i < 6; ++i) {
      constexpr double kStep = 1e-6;
      double& x = state.poses[0].parameters[i];
      const double middle = x;
      double cost[2];
      for (const int side : {0, 1}) {
        x = middle + (side ? kStep : -kStep);
        data.sweep (state, Pass::LinearizeKept);
        cost[side] = data.of (0).cost();
      }
      x = middle;
      const double numeric = (cost[1] - cost[0]) / (2.0 * kStep);
      const double scale = std::sqrt (2.0 * q.cost() * q.information (i, i));
      EXPECT_NEAR (q.gradient[i], numeric, 1e-5 * scale) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P (Angles, Gradient, testing::Values (0.0, 0.01, 0.8, 2.5, 3.1));

/** The room cut into tiles, linearized beside the truth. */
std::vector<SegmentQuadratic>
roomQuadratics (int threads, Pass last, std::vector<double>* probes)
{
  const test::AnalyticScene scene = test::roomWithBox();
  const FrameLevel reference = scene.frame (scene.render (false)).levels()[0];
  const Texture texture (scene.frame (scene.render (true)).levels()[0]);
  cv::Mat labels (scene.height, scene.width, CV_32SC1);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      labels.at<int> (y, x) = y / 20 * 8 + x / 20;
  const SegmentPixels pixels = test::pointsOf (reference, labels, 48, {}, 0.01);
  DataTerm data (pixels, texture, makeRules ({}, pixels), threads);
  const MotionState state =
      MotionState::fromSegments (std::vector<RigidPose> (48, scene.motions[0]), 0);
  data.sweep (state, Pass::Linearize);
  data.sweep (state, last);
  std::vector<SegmentQuadratic> result;
  for (int k = 0; k < 48; ++k) {
    result.push_back (data.of (k));
    probes->push_back (data.probe (k, scene.motions[1]).cost);
  }
  return result;
}

TEST (DataTerm, SameBitsForAnyNumberOfThreads)
{
  for (const Pass pass : {Pass::Linearize, Pass::LinearizeKept, Pass::Cost}) {
    std::vector<double> one_probes;
    const auto one = roomQuadratics (1, pass, &one_probes);
    EXPECT_GT (one[20].cost(), 0.0);
    for (const int threads : {1, 2, 5}) {
      std::vector<double> probes;
      const auto many = roomQuadratics (threads, pass, &probes);
      EXPECT_EQ (probes, one_probes);
      for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_EQ (many[k].information, one[k].information);
        EXPECT_EQ (many[k].gradient, one[k].gradient);
        EXPECT_EQ (many[k].brightness_cost, one[k].brightness_cost);
        EXPECT_EQ (many[k].icp_cost, one[k].icp_cost);
      }
    }
  }
}

} // namespace
