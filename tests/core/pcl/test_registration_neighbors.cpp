// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/common/transforms.h>

#include <gtest/gtest.h>

#include "support/chain_clouds.h"
#include "support/slid_clouds.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl_msf;
using pcl_msf::testing::BoxChain;
using pcl_msf::testing::ChainCloud;
using pcl_msf::testing::cloudOf;
using pcl_msf::testing::drawChain;
using ::testing::HasSubstr;
using ::testing::Not;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = PiecewiseRigidRegistration<pcl::PointXYZ>;

class NeighborRegistration : public ::testing::Test {
protected:
  static constexpr int kPoints = 2000;

  NeighborRegistration()
  {
    chain.boxes = 2;
    source = drawChain (chain, kPoints, false, 1);
    target = drawChain (chain, kPoints, true, 2);
    registration.setInputSource (cloudOf<pcl::PointXYZ> (source.points));
    registration.setInputTarget (cloudOf<pcl::PointXYZ> (target.points));
  }
  double
  error (const pcl::PointXYZ& point, int index) const
  {
    return (point.getVector3fMap().cast<double>() -
            chain.pose (source.box[index]) * source.rest[index].cast<double>())
        .norm();
  }

  /** Mean error of points that a motion took away after it. */
  double
  meanError (const Cloud& warped, const RigidPose& away) const
  {
    const RigidPose back = away.inverse();
    double sum = 0.0;
    for (int i = 0; i < kPoints; ++i) {
      const Eigen::Vector3f p =
          (back * warped[i].getVector3fMap().cast<double>()).cast<float>();
      sum += error (pcl::PointXYZ (p.x(), p.y(), p.z()), i);
    }
    return sum / kPoints;
  }
  void
  takeTargetAway (const RigidPose& away)
  {
    const auto moved = cloudOf<pcl::PointXYZ> (target.points);
    pcl::transformPointCloud (*moved, *moved, away.matrix());
    registration.setInputTarget (moved);
  }

  const RigidPose far{{0.0, 0.0, 2.0, 1.0, 0.5, 0.0}};
  BoxChain chain;
  ChainCloud source;
  ChainCloud target;
  Registration registration;
};

TEST_F (NeighborRegistration, TakesCloudsWithoutAGrid)
{
  pcl::Registration<pcl::PointXYZ, pcl::PointXYZ>& base = registration;
  Cloud warped;
  base.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << registration.getReport().message;
  ASSERT_EQ (warped.size(), source.points.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < warped.size(); ++i)
    sum += error (warped[i], static_cast<int> (i));
  EXPECT_LT (sum / static_cast<double> (warped.size()), 2e-3);
  ASSERT_EQ (registration.getJoints().size(), 1u);
  EXPECT_NEAR (registration.getJoints()[0].angle, chain.angle, 0.02);
  EXPECT_GT (registration.getCorrespondences().size(), 1750u);
  EXPECT_LT (registration.getFitnessScore(), 1e-3);
  EXPECT_EQ (registration.getSceneFlow().labels.cols, kPoints);
  EXPECT_TRUE (
      registration.getPose (0, 1, 0).isApprox (registration.getFinalTransformation()));
}

TEST_F (NeighborRegistration, LeavesOutWhatTheIndicesLeaveOut)
{
  auto indices = pcl::make_shared<pcl::Indices>();
  for (int i = 1; i < kPoints; i += 2)
    indices->push_back (i);
  registration.setIndices (indices);
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged());
  ASSERT_EQ (warped.size(), 1000u);
  EXPECT_LT (error (warped[10], (*indices)[10]), 0.01);
  for (const auto& pair : registration.getCorrespondences())
    EXPECT_EQ (pair.index_query % 2, 1);
}

TEST_F (NeighborRegistration, SaysWhatItCannotTake)
{
  const auto refused = [this] {
    Cloud warped;
    ::testing::internal::CaptureStderr();
    registration.align (warped);
    EXPECT_FALSE (registration.hasConverged());
    EXPECT_TRUE (registration.getJoints().empty());
    return ::testing::internal::GetCapturedStderr();
  };
  std::vector<pcl::PointIndices> clusters (1);
  clusters[0].indices = {0, 1, kPoints};
  registration.setSegmentation (clusters);
  EXPECT_THAT (refused(), HasSubstr ("index 2000"));
  registration.setSegmentation (
      pcl::make_shared<pcl::PointCloud<pcl::Label>> (200, 20));
  EXPECT_THAT (refused(), HasSubstr ("clearSegmentation"));
  registration.clearSegmentation();
  CloudConstraints constraints;
  constraints.point_weights.resize (20, 1.0F);
  registration.setCloudConstraints (constraints);
  EXPECT_THAT (refused(), HasSubstr ("setCloudConstraints"));
  registration.setCloudConstraints ({{{kPoints, 0}}, {}, {}, {}});
  EXPECT_THAT (refused(), HasSubstr ("index 2000"));
  registration.setCloudConstraints ({});
  registration.setCorrespondence (CorrespondenceMethod::Projective);
  EXPECT_THAT (refused(), HasSubstr ("not organized"));
}

TEST_F (NeighborRegistration, SegmentsFromOutsideAreItsSegments)
{
  auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>> (kPoints, 1);
  for (int i = 0; i < kPoints; ++i)
    (*labels)[i].label = i < 40 ? 4294967295U : 3 + 6 * source.box[i];
  registration.setSegmentation (labels);
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << registration.getReport().message;
  const SceneFlow& flow = registration.getSceneFlow();
  ASSERT_EQ (flow.segments.size(), 2u);
  ASSERT_EQ (flow.pairs.size(), 1u);
  EXPECT_EQ (flow.pairs[0].weight, 0.0);
  EXPECT_EQ (flow.groups, 2);
  for (int i = 0; i < kPoints; ++i) {
    ASSERT_EQ (flow.labels.at<int> (0, i), i < 40 ? -1 : source.box[i]);
    ASSERT_EQ (std::isnan (warped[i].x), i < 40);
    ASSERT_TRUE (i < 40 || error (warped[i], i) < 3e-3);
  }
  EXPECT_EQ (flow.segments[0].points + flow.segments[1].points, kPoints - 40);
  EXPECT_LT (flow.segments[0].centroid.x(), flow.segments[1].centroid.x());

  // The same as clusters, in the other order, of the points of one half.
  std::vector<pcl::PointIndices> clusters (2);
  for (int i = 0; i < kPoints; ++i)
    clusters[1 - source.box[i]].indices.push_back (i);
  registration.setSegmentation (clusters);
  auto half = pcl::make_shared<pcl::Indices>();
  for (int i = 0; i < kPoints; i += 2)
    half->push_back (i);
  registration.setIndices (half);
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << registration.getReport().message;
  for (int i = 0; i < kPoints; i += 2)
    ASSERT_EQ (registration.getSceneFlow().labels.at<int> (0, i), 1 - source.box[i]);
}

TEST_F (NeighborRegistration, BeginsAtTheGuess)
{
  takeTargetAway (far);
  Cloud warped;
  ::testing::internal::CaptureStderr();
  registration.align (warped);
  ::testing::internal::GetCapturedStderr();
  EXPECT_GT (meanError (warped, far), 0.05);
  pcl::Registration<pcl::PointXYZ, pcl::PointXYZ>& base = registration;
  base.align (warped, (far * chain.pose (0)).matrix());
  EXPECT_TRUE (registration.hasConverged()) << registration.getReport().message;
  EXPECT_LT (meanError (warped, far), 2e-3);
}

TEST_F (NeighborRegistration, KnownCorrespondencesLeadIt)
{
  takeTargetAway (far);
  pcl::Correspondences pairs;
  const auto targets = cloudOf<pcl::PointXYZ> (target.points);
  for (int i = 0; i < kPoints; i += kPoints / 8) {
    const auto nearest = std::min_element (
        targets->begin(), targets->end(), [&] (const auto& a, const auto& b) {
          return error (a, i) < error (b, i);
        });
    pairs.emplace_back (i, static_cast<int> (nearest - targets->begin()), 0.0F);
  }
  registration.setKnownCorrespondences (pairs);
  Cloud warped;
  registration.align (warped);
  EXPECT_TRUE (registration.hasConverged()) << registration.getReport().message;
  EXPECT_LT (meanError (warped, far), 2e-3);
}

TEST_F (NeighborRegistration, ConstraintsAreKeptAndBadOnesAreRefused)
{
  const auto refused = [] (const std::string& method, const auto& call) {
    ::testing::internal::CaptureStderr();
    call();
    EXPECT_THAT (::testing::internal::GetCapturedStderr(), HasSubstr (method));
  };
  pcl::Correspondences pairs;
  pairs.emplace_back (3, 4, 0.0F);
  registration.setKnownCorrespondences (pairs, {0.5});
  pairs.emplace_back (5, -1, 0.0F);
  refused ("setKnownCorrespondences",
           [&] { registration.setKnownCorrespondences (pairs); });
  refused ("setKnownCorrespondences", [&] {
    registration.setKnownCorrespondences (pairs, {1.0, 2.0, 3.0});
  });
  CloudConstraints constraints = registration.getCloudConstraints();
  ASSERT_EQ (constraints.pairs.size(), 1u);
  EXPECT_EQ (registration.getKnownCorrespondences()[0].weight, 0.5F);
  constraints.point_weights = {NAN};
  refused ("setCloudConstraints",
           [&] { registration.setCloudConstraints (constraints); });
  EXPECT_TRUE (registration.getCloudConstraints().point_weights.empty());
  // By the camera they have no meaning.
  registration.setCorrespondence (CorrespondenceMethod::Projective);
  auto organized = cloudOf<pcl::PointXYZ> (source.points);
  organized->width = kPoints / 40;
  organized->height = 40;
  registration.setInputSource (organized);
  registration.setInputTarget (organized);
  Cloud warped;
  refused ("setCloudConstraints", [&] { registration.align (warped); });
  EXPECT_FALSE (registration.hasConverged());
}

TEST_F (NeighborRegistration, TellsToKeepTheGridOfACamerasClouds)
{
  const auto missed = [this] (const Eigen::Vector3f& offset) {
    for (std::size_t i = 0; i < target.points.size(); ++i) // nothing alike
      target.points[i] = 0.5f * Eigen::Vector3f::Random() + offset;
    for (auto& p : source.points)
      p += offset;
    registration.setInputSource (cloudOf<pcl::PointXYZ> (source.points));
    registration.setInputTarget (cloudOf<pcl::PointXYZ> (target.points));
    Cloud warped;
    ::testing::internal::CaptureStderr();
    registration.align (warped);
    ::testing::internal::GetCapturedStderr();
    EXPECT_EQ (registration.getReport().stop_reason, StopReason::DifferentPlaces);
    return registration.getReport().message;
  };
  EXPECT_THAT (missed ({0.0f, 0.0f, 0.0f}), Not (HasSubstr ("setKeepOrganized")));
  EXPECT_THAT (missed ({0.0f, 0.0f, 4.0f}), HasSubstr ("setKeepOrganized"));
}

TEST_F (NeighborRegistration, TheMethodIsKeptAndBadOnesAreRefused)
{
  EXPECT_EQ (registration.getCorrespondence(), CorrespondenceMethod::Auto);
  registration.setCorrespondence (CorrespondenceMethod::NearestNeighbor);
  ::testing::internal::CaptureStderr();
  registration.setCorrespondence (static_cast<CorrespondenceMethod> (7));
  EXPECT_THAT (::testing::internal::GetCapturedStderr(),
               HasSubstr ("setCorrespondence"));
  EXPECT_EQ (registration.getCorrespondence(), CorrespondenceMethod::NearestNeighbor);
}

template <typename PointT, typename Paint>
typename pcl::PointCloud<PointT>::Ptr
painted (const std::vector<Eigen::Vector3f>& points,
         const std::vector<float>& brightness,
         const Paint& paint)
{
  const auto cloud = pcl_msf::testing::cloudOf<PointT> (points);
  for (std::size_t i = 0; i < points.size(); ++i)
    paint ((*cloud)[i], brightness[i]);
  return cloud;
}

/** Error of a cylinder's turn about its axis. */
template <typename PointT, typename Paint>
double
turnError (const Paint& paint, double brightness_weight = 1.0)
{
  const auto clouds = pcl_msf::testing::turnedCylinder (0.3);
  PiecewiseRigidRegistration<PointT> registration;
  registration.setInputSource (
      painted<PointT> (clouds.source, clouds.source_brightness, paint));
  registration.setInputTarget (
      painted<PointT> (clouds.target, clouds.target_brightness, paint));
  EnergyParameters energy;
  energy.brightness_weight = brightness_weight;
  registration.setEnergyParameters (energy);
  pcl::PointCloud<PointT> warped;
  registration.align (warped);
  std::vector<Eigen::Vector3f> points;
  for (const PointT& p : warped)
    points.emplace_back (p.getVector3fMap());
  return clouds.meanError (points);
}

TEST (NeighborColors, TellWhatSlidesWithinItsSurface)
{
  const auto intensity = [] (auto& point, float b) { point.intensity = 4000.0f * b; };
  const auto rgb = [] (auto& point, float b) {
    point.r = point.g = point.b = static_cast<std::uint8_t> (255.0f * b);
  };
  EXPECT_GT (turnError<pcl::PointXYZI> (intensity, 0.0), 0.03) << "not asked for";
  EXPECT_LT (turnError<pcl::PointXYZI> (intensity), 2e-3);
  EXPECT_LT (turnError<pcl::PointXYZINormal> (intensity), 2e-3);
  EXPECT_LT (turnError<pcl::PointXYZRGB> (rgb), 2e-3);
  EXPECT_LT (turnError<pcl::PointXYZRGBA> (rgb), 2e-3);
  EXPECT_LT (turnError<pcl::PointXYZRGBNormal> (rgb), 2e-3);
}

} // namespace
