// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/data/data_term.h"
#include "support/points.h"

#include <cmath>
#include <memory>

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
    data_ = std::make_unique<DataTerm> (
        pixels_, *texture_, makeRules (energy, pixels_, {}), 1);
  }

  const SegmentQuadratic&
  shifted (double x, double y, double z)
  {
    RigidPose pose;
    pose.parameters = {0, 0, 0, x, y, z};
    data_->sweep (MotionState::fromSegments ({pose}, 0), Pass::Linearize);
    return data_->of (0);
  }

  /** The cost at kept correspondences. */
  double
  cost (double x)
  {
    RigidPose pose;
    pose.parameters[3] = x;
    data_->sweep (MotionState::fromSegments ({pose}, 0), Pass::LinearizeKeptInDouble);
    return data_->of (0).cost();
  }
  /** As if something had weighed the points by a factor. */
  void
  scaleBrightness (float factor)
  {
    pixels_.brightness_scale[0] *= factor;
    data_->forget();
  }
  void
  setRules (const kernel::Rules& rules)
  {
    data_->setRules (rules);
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

TEST (DataTerm, SumsAtAPoseAreThoseOfTheLastWeights)
{
  OnePoint point (squares());
  const SegmentQuadratic first = point.shifted (0.1, 0.0, 0.0);
  EXPECT_LT (point.cost (0.05), 0.5 * first.cost());
  const SegmentQuadratic again = point.shifted (0.1, 0.0, 0.0);
  EXPECT_EQ (again.brightness_cost, first.brightness_cost);
  EXPECT_EQ (again.information, first.information);
  EXPECT_EQ (point.shifted (0.1, 0.0, 0.0).gradient, first.gradient);
  point.scaleBrightness (2.0f);
  EXPECT_NEAR (point.shifted (0.1, 0.0, 0.0).brightness_cost,
               4.0 * first.brightness_cost,
               1e-6 * first.brightness_cost);
  kernel::Rules rules = point.rules();
  rules.brightness_weight *= 0.25f;
  point.setRules (rules);
  EXPECT_NEAR (point.shifted (0.1, 0.0, 0.0).brightness_cost,
               first.brightness_cost,
               1e-6 * first.brightness_cost);
}

TEST (DataTerm, TermsAreWeightedAndDividedByTheirCounts)
{
  EnergyParameters energy = squares();
  energy.brightness_weight = 3.0;
  energy.icp_weight = 0.5;
  SegmentPixels pixels;
  pixels.brightness_count = 6;
  pixels.icp_count = 4;
  const kernel::Rules rules = makeRules (energy, pixels, {});
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

} // namespace
