// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/box_chain.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cmath>

namespace {

using namespace pcl_msf;
using pcl_msf::testing::BoxChain;
using pcl_msf::testing::ChainCloud;
using pcl_msf::testing::drawChain;
using ::testing::HasSubstr;
using ::testing::Not;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = PiecewiseRigidRegistration<pcl::PointXYZ>;

Cloud::Ptr
cloudOf (const ChainCloud& chain)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (const auto& p : chain.points)
    cloud->emplace_back (p.x(), p.y(), p.z());
  return cloud;
}

class NeighborRegistration : public ::testing::Test {
protected:
  NeighborRegistration()
  {
    chain.boxes = 2;
    source = drawChain (chain, 4000, false, 1);
    target = drawChain (chain, 4000, true, 2);
    registration.setInputSource (cloudOf (source));
    registration.setInputTarget (cloudOf (target));
  }
  double
  error (const pcl::PointXYZ& point, int index) const
  {
    return (point.getVector3fMap().cast<double>() -
            chain.pose (source.box[index]) * source.rest[index].cast<double>())
        .norm();
  }

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
  EXPECT_GT (registration.getCorrespondences().size(), 3500u);
  EXPECT_LT (registration.getFitnessScore(), 1e-3);
  EXPECT_EQ (registration.getSceneFlow().labels.cols, 4000);
  EXPECT_TRUE (
      registration.getPose (0, 1, 0).isApprox (registration.getFinalTransformation()));
}

TEST_F (NeighborRegistration, LeavesOutWhatTheIndicesLeaveOut)
{
  auto indices = pcl::make_shared<pcl::Indices>();
  for (int i = 1; i < 4000; i += 2)
    indices->push_back (i);
  registration.setIndices (indices);
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged());
  ASSERT_EQ (warped.size(), 2000u);
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
  registration.addInputTarget (cloudOf (target));
  EXPECT_THAT (refused(), HasSubstr ("one target"));
  registration.setInputTarget (cloudOf (target));
  std::vector<pcl::PointIndices> clusters (1);
  clusters[0].indices = {0, 1, 2};
  registration.setSegmentation (clusters);
  EXPECT_THAT (refused(), HasSubstr ("clearSegmentation"));
  registration.clearSegmentation();
  registration.setCorrespondence (CorrespondenceMethod::Projective);
  EXPECT_THAT (refused(), HasSubstr ("not organized"));
}

TEST_F (NeighborRegistration, TellsToKeepTheGridOfACamerasClouds)
{
  const auto missed = [this] (const Eigen::Vector3f& offset) {
    for (std::size_t i = 0; i < target.points.size(); ++i) // nothing alike
      target.points[i] = 0.5f * Eigen::Vector3f::Random() + offset;
    for (auto& p : source.points)
      p += offset;
    registration.setInputSource (cloudOf (source));
    registration.setInputTarget (cloudOf (target));
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

} // namespace
