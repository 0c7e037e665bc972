// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/base/instruction_set.h"
#include "core/data/data_term.h"
#include "support/analytic_scene.h"
#include "support/points.h"

#include <cmath>
#include <random>

namespace {

using namespace pcl_msf;
using Pass = DataTerm::Pass;

constexpr int kSize = 32;
const PinholeCamera kCamera{40.0, 40.0, 15.5, 15.5};

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

/** Every instruction set's kernel against the one that any processor runs. */
class Kernels : public testing::TestWithParam<double> {
protected:
  Kernels()
  {
    cv::Mat labels (kSize, kSize, CV_32SC1, cv::Scalar (0));
    pixels_ = test::pointsOf (bumps (0.3), labels, 1, NoiseModel{}, 0.4);
    pixels_.brightness_scale[5] = 0.0f; // neither of these has both residuals
    pixels_.icp_scale[6] = 0.0f;
    offset_.assign (pixels_.pixel.size(), 0.0f);
    active_.assign (pixels_.pixel.size(), 0);
  }

  /** The data of all points but the last `cut`, which the sets' widths do not divide.
   */
  kernel::Points
  points (int cut) const
  {
    const SegmentPixels& p = pixels_;
    return {p.x.data(),
            p.y.data(),
            p.z.data(),
            p.intensity.data(),
            p.nx.data(),
            p.ny.data(),
            p.nz.data(),
            p.brightness_scale.data(),
            p.icp_scale.data(),
            p.depth_tolerance.data(),
            static_cast<int> (p.pixel.size()) - cut};
  }

  /** All sums of a kernel's functions, one after the other. */
  std::vector<double>
  sumsOf (const kernel::Kernel& kernel, int cut)
  {
    const kernel::Motion motion = turned (GetParam());
    const kernel::Rules rules = makeRules ({}, pixels_, {});
    const kernel::Correspondences state{offset_.data(), active_.data()};
    std::vector<double> all;
    kernel::Sums linear{};
    kernel.linearize (points (cut), texture_.image(), motion, rules, state, linear);
    append (linear, all);
    kernel::Sums sums{};
    kernel.probe (points (cut), texture_.image(), motion, rules, sums);
    append (sums, all);
    return all;
  }

  const std::vector<std::uint8_t>&
  active () const
  {
    return active_;
  }

private:
  static kernel::Motion
  turned (double angle)
  {
    const Eigen::Matrix3d r =
        Eigen::AngleAxisd (angle, Eigen::Vector3d (0.3, 0.5, 0.8).normalized())
            .toRotationMatrix();
    kernel::Motion m{};
    for (int i = 0; i < 9; ++i)
      m.rotation[i] = m.normal_rotation[i] = r (i / 3, i % 3);
    m.translation[0] = 0.04;
    m.translation[2] = 0.02;
    m.origin[2] = 2.0;
    return m;
  }
  static void
  append (const kernel::Sums& sums, std::vector<double>& all)
  {
    all.insert (all.end(), std::begin (sums.a), std::end (sums.a));
    all.insert (all.end(), std::begin (sums.b), std::end (sums.b));
    all.insert (all.end(), {sums.brightness_cost, sums.icp_cost, sums.hidden});
  }

  SegmentPixels pixels_;
  Texture texture_{bumps (0.9)};
  std::vector<float> offset_;
  std::vector<std::uint8_t> active_;
};

TEST_P (Kernels, OfAllInstructionSetsAgree)
{
  for (const int cut : {0, 1, 13, 1020}) {
    const std::vector<double> plain = sumsOf (kernel::usableKernels().back(), cut);
    const std::vector<std::uint8_t> seen = active();
    double largest = 0.0;
    for (const double value : plain)
      largest = std::max (largest, std::abs (value));
    ASSERT_GT (largest, 0.0);
    for (const kernel::Kernel& kernel : kernel::usableKernels()) {
      const std::vector<double> sums = sumsOf (kernel, cut);
      for (std::size_t i = 0; i < sums.size(); ++i)
        EXPECT_NEAR (sums[i], plain[i], 1e-5 * largest) << kernel.name << ", sum " << i;
      EXPECT_EQ (active(), seen) << kernel.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P (Angles, Kernels, testing::Values (0.0, 0.02, 0.3));

TEST (KernelChoice, EndsWithTheOneOfAnyProcessor)
{
  EXPECT_STREQ (kernel::usableKernels().back().name, "default");
  EXPECT_EQ (kernel::usableKernels().size(), usableInstructionSets().size());
  EXPECT_STREQ (kernel::chosenKernel().name, nameOf (chosenInstructionSet()));
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
  DataTerm data (pixels, texture, makeRules ({}, pixels, {}), 1);
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
    data.sweep (state, Pass::LinearizeKeptInDouble);
    const SegmentQuadratic q = data.of (0);
    for (int i = 0; i < 6; ++i) {
      constexpr double kStep = 1e-6;
      double& x = state.poses[0].parameters[i];
      const double middle = x;
      double cost[2];
      for (const int side : {0, 1}) {
        x = middle + (side ? kStep : -kStep);
        data.sweep (state, Pass::LinearizeKeptInDouble);
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
  DataTerm data (pixels, texture, makeRules ({}, pixels, {}), threads);
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
  for (const Pass pass : {Pass::Linearize, Pass::LinearizeKeptInDouble}) {
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

TEST (DataTerm, SegmentsGoBackToTheSumsThatWereKept)
{
  cv::Mat labels (kSize, kSize, CV_32SC1, cv::Scalar (0));
  labels.colRange (kSize / 2, kSize).setTo (1);
  const SegmentPixels pixels =
      test::pointsOf (bumps (0.3), labels, 2, NoiseModel{}, 0.4);
  const Texture texture (bumps (0.5));
  DataTerm data (pixels, texture, makeRules ({}, pixels, {}), 1);
  const MotionState before = MotionState::fromSegments (std::vector<RigidPose> (2), 0);
  MotionState after = before;
  for (RigidPose& pose : after.poses)
    pose.parameters[3] = 0.1;
  data.sweep (before, Pass::Linearize);
  const SegmentQuadratic kept = data.of (0);
  const std::vector<std::uint8_t> active = data.active();
  data.rememberSums();
  data.sweep (after, Pass::Linearize);
  const SegmentQuadratic other = data.of (1);
  ASSERT_NE (data.of (0).cost(), kept.cost());
  data.recallSums (0);
  EXPECT_EQ (data.of (0).information, kept.information);
  EXPECT_EQ (data.of (0).gradient, kept.gradient);
  EXPECT_EQ (data.of (0).cost(), kept.cost());
  EXPECT_EQ (data.frozenPose (0).parameters, before.poses[0].parameters);
  EXPECT_EQ (data.of (1).information, other.information);
  // Correspondences come back with the next sweep after completeSums.
  data.completeSums();
  data.sweep (before, Pass::Linearize);
  EXPECT_EQ (data.active(), active);
  EXPECT_EQ (data.of (0).information, kept.information);
}

} // namespace
