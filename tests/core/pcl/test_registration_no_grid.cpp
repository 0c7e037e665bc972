// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/chain_clouds.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <algorithm>
#include <limits>
#include <string>

/* What counts as a cloud without a grid, and that no camera has a say there. */
namespace {

using namespace pcl_msf;
using pcl_msf::testing::BoxChain;
using pcl_msf::testing::drawChain;
using ::testing::HasSubstr;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = PiecewiseRigidRegistration<pcl::PointXYZ>;
using BaseRegistration = pcl::Registration<pcl::PointXYZ, pcl::PointXYZ>;

constexpr std::uint32_t kPoints = 1000;

BoxChain
twoBoxes ()
{
  BoxChain chain;
  chain.boxes = 2;
  return chain;
}

/** A body around the origin: half of it has z < 0. */
Cloud::Ptr
body (bool moved)
{
  const BoxChain chain = twoBoxes();
  return pcl_msf::testing::cloudOf<pcl::PointXYZ> (
      drawChain (chain, kPoints, moved, moved ? 2 : 1).points);
}

/** The same points with a width and a height that need not fit. */
Cloud::Ptr
shaped (const Cloud& cloud, std::uint32_t width, std::uint32_t height)
{
  auto copy = pcl::make_shared<Cloud> (cloud);
  copy->width = width;
  copy->height = height;
  return copy;
}

/** What PCL's own search finds. */
double
fitnessByAll (const Cloud& source, const Cloud& target, const Eigen::Matrix4f& motion)
{
  double sum = 0.0;
  for (const auto& p : source) {
    const Eigen::Vector3f moved = (motion * p.getVector4fMap()).head<3>();
    float nearest = std::numeric_limits<float>::max();
    for (const auto& q : target)
      nearest = std::min (nearest, (q.getVector3fMap() - moved).squaredNorm());
    sum += nearest;
  }
  return sum / static_cast<double> (source.size());
}

class NoGrid : public ::testing::Test {
protected:
  void
  give (const Cloud::Ptr& source, const Cloud::Ptr& target)
  {
    registration.setInputSource (source);
    registration.setInputTarget (target);
  }
  /** Aligns behind the base pointer. \return what was printed */
  std::string
  printed ()
  {
    BaseRegistration& base = registration;
    ::testing::internal::CaptureStderr();
    base.align (warped);
    return ::testing::internal::GetCapturedStderr();
  }

  const Cloud::Ptr source = body (false);
  const Cloud::Ptr target = body (true);
  Registration registration;
  Cloud warped;
};

TEST_F (NoGrid, NoPointIsLeftOutOfTheSearchForBeingBehindACamera)
{
  give (source, target);
  ASSERT_EQ (printed(), "");
  BaseRegistration& base = registration;
  const double wanted =
      fitnessByAll (*source, *target, registration.getFinalTransformation());
  EXPECT_NEAR (base.getFitnessScore(), wanted, 1e-3 * wanted);
  Registration copy (registration);
  EXPECT_EQ (static_cast<BaseRegistration&> (copy).getFitnessScore(),
             base.getFitnessScore());
  pcl::Indices indices;
  std::vector<float> distances;
  for (const auto& p : *target) {
    base.getSearchMethodTarget()->nearestKSearch (p, 1, indices, distances);
    ASSERT_EQ (distances.at (0), 0.0F) << p;
  }
  // A failure has no camera either.
  target->clear();
  EXPECT_THAT (printed(), HasSubstr ("the target is empty"));
  base.getSearchMethodTarget()->setInputCloud (source);
  EXPECT_EQ (
      base.getSearchMethodTarget()->nearestKSearch ({}, 1000, indices, distances),
      1000);
}

TEST_F (NoGrid, CloudsFilledThroughTheirPointsAreTaken)
{
  const auto labels = pcl::make_shared<pcl::PointCloud<pcl::Label>>();
  for (const auto& p : *source) {
    labels->points.emplace_back();
    labels->points.back().label = pcl_msf::testing::boxOf (twoBoxes(), p);
  }
  registration.setSegmentation (labels);
  for (const auto& [width, height] : {std::pair (0U, 0U), {7U, 9U}, {kPoints, 0U}}) {
    SCOPED_TRACE (std::to_string (width) + "x" + std::to_string (height));
    give (shaped (*source, width, height), shaped (*target, width, height));
    EXPECT_EQ (printed(), "");
    ASSERT_TRUE (registration.hasConverged());
    EXPECT_EQ (warped.width, kPoints);
    EXPECT_EQ (warped.height, 1U);
    EXPECT_EQ (registration.getWarpedCloud (1).width, kPoints);
    EXPECT_EQ (registration.getWarpedCloud (0).height, 1U);
    EXPECT_EQ (registration.getSceneFlow().labels.cols, static_cast<int> (kPoints));
  }
  // The source alone, which is the output, too.
  const Cloud::Ptr listed = shaped (*source, 0, 0);
  give (listed, target);
  registration.align (*listed);
  EXPECT_TRUE (registration.hasConverged());
  EXPECT_EQ (listed->width, kPoints);
}

TEST_F (NoGrid, AColumnIsTakenAndStaysOne)
{
  give (shaped (*source, 1, kPoints), shaped (*target, 1, kPoints));
  EXPECT_EQ (printed(), "");
  ASSERT_TRUE (registration.hasConverged());
  EXPECT_EQ (warped.width, 1U);
  EXPECT_EQ (warped.height, kPoints);
  EXPECT_EQ (registration.getSceneFlow().labels.rows, static_cast<int> (kPoints));
  EXPECT_GT (registration.getCorrespondences().size(), kPoints / 2);
}

TEST_F (NoGrid, TheCamerasWayNamesTheOther)
{
  registration.setCorrespondence (CorrespondenceMethod::Projective);
  for (const auto& [width, height] :
       {std::pair (0U, 0U), {7U, 9U}, {1U, kPoints}, {kPoints, 1U}}) {
    const std::string size = std::to_string (width) + "x" + std::to_string (height);
    give (shaped (*source, width, height), target);
    const std::string message = printed();
    EXPECT_THAT (message, HasSubstr ("setCorrespondence"));
    EXPECT_EQ (warped.size(), kPoints);
    EXPECT_EQ (registration.getReport().stop_reason, StopReason::InvalidInput);
    EXPECT_THAT (message, HasSubstr ("(" + size + ", 1000 points)"));
  }
  give (shaped (*source, 40, 25), shaped (*target, 1, kPoints));
  EXPECT_THAT (printed(), HasSubstr ("the target is not organized (1x1000"));
}

} // namespace
