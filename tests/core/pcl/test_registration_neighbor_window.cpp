// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/chain_clouds.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cmath>
#include <string>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::testing;
using ::testing::HasSubstr;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = PiecewiseRigidRegistration<pcl::PointXYZ>;

/** Three scans of a chain that bends on, the second and third as targets. */
class NeighborWindow : public ::testing::Test {
protected:
  static constexpr int kPoints = 1250;

  NeighborWindow()
  {
    source = cloudOf<pcl::PointXYZ> (drawChain (bent (1), kPoints, false, 1).points);
    for (int t = 1; t <= 2; ++t)
      targets.push_back (cloudOf<pcl::PointXYZ> (
          drawChain (bent (t), kPoints, true, 1 + static_cast<unsigned> (t)).points));
    registration.setInputSource (source);
    registration.setNumberOfThreads (2);
  }
  void
  setTargets ()
  {
    registration.setInputTargets ({targets[0], targets[1]});
  }
  std::string
  refusal ()
  {
    Cloud warped;
    ::testing::internal::CaptureStderr();
    registration.align (warped);
    EXPECT_FALSE (registration.hasConverged());
    return ::testing::internal::GetCapturedStderr();
  }

  Cloud::Ptr source;
  std::vector<Cloud::Ptr> targets;
  Registration registration;
};

TEST_F (NeighborWindow, GivesEveryFrame)
{
  setTargets();
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << registration.getReport().message;
  EXPECT_LT (meanChainError (bent (2), *source, warped), 3e-3);
  EXPECT_LT (meanChainError (bent (1), *source, registration.getWarpedCloud (1)), 3e-3);
  const MultiframeSceneFlow& flow = registration.getMultiframeSceneFlow();
  ASSERT_EQ (flow.frames.size(), 3u);
  EXPECT_EQ (flow.motions.size(), 2u);
  EXPECT_EQ (cv::norm (flow.frames[1].labels, flow.frames[2].labels, cv::NORM_INF), 0);
  // The last target's, and the others by their frame.
  ASSERT_GE (registration.getJoints().size(), 1u);
  EXPECT_NEAR (registration.getJoints()[0].angle, 0.2, 0.03);
  EXPECT_NEAR (registration.getJoints (1)[0].angle, 0.1, 0.03);
  EXPECT_TRUE (registration.getJoints (0).empty());
  EXPECT_TRUE (
      registration.getPose (0, 2, 0).isApprox (registration.getFinalTransformation()));
  EXPECT_TRUE ((registration.getPose (1, 2, 0) * registration.getPose (0, 1, 0))
                   .isApprox (registration.getPose (0, 2, 0), 1e-5F));
  EXPECT_GT (registration.getCorrespondences().size(), 1000u);
  EXPECT_LT (registration.getFitnessScore(), 1e-3);
}

TEST_F (NeighborWindow, TheSourceMayBeTheLastFrame)
{
  registration.setInputTargets ({targets[1], targets[0]});
  registration.setReferenceFrame (2);
  pcl::Registration<pcl::PointXYZ, pcl::PointXYZ>& base = registration;
  Cloud warped;
  base.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << registration.getReport().message;
  EXPECT_LT (meanChainError (bent (1), *source, warped), 3e-3);
  EXPECT_LT (meanChainError (bent (2), *source, registration.getWarpedCloud (0)), 3e-3);
  EXPECT_EQ (registration.getWarpedCloud (2).size(), source->size());
}

TEST_F (NeighborWindow, OneTargetIsAWindowOfTwo)
{
  registration.setInputTargets ({targets[0]});
  Cloud listed;
  registration.align (listed);
  registration.setInputTarget (targets[0]);
  Cloud single;
  registration.align (single);
  for (std::size_t i = 0; i < single.size(); ++i)
    ASSERT_EQ (single[i].getVector3fMap(), listed[i].getVector3fMap());
}

TEST_F (NeighborWindow, TellsOfATargetThatWasNotFound)
{
  for (auto& p : *targets[0])
    p.getVector3fMap() =
        0.2F * Eigen::Vector3f (std::sin (p.x * 91.0F), p.y, std::cos (p.x));
  setTargets();
  EXPECT_THAT (refusal(), HasSubstr ("target 1: "));
  EXPECT_FALSE (registration.getSceneFlow (1).report.converged);
}

TEST_F (NeighborWindow, SaysWhatItCannotTake)
{
  setTargets();
  registration.setReferenceFrame (3);
  EXPECT_THAT (refusal(), HasSubstr ("setReferenceFrame"));
  registration.setReferenceFrame (0);
  registration.setCloudConstraints ({{{1, 1, 1.0, 2}}, {}, {}, {}});
  EXPECT_THAT (refusal(), HasSubstr ("target 2"));
  CloudConstraints wrong;
  wrong.pairs = {{1, 1, 1.0, -1}};
  ::testing::internal::CaptureStderr();
  registration.setCloudConstraints (wrong);
  EXPECT_THAT (::testing::internal::GetCapturedStderr(),
               HasSubstr ("setCloudConstraints"));
  EXPECT_EQ (registration.getCloudConstraints().pairs[0].cloud, 2);
  registration.setCloudConstraints ({});
  ::testing::internal::CaptureStderr();
  EXPECT_TRUE (registration.getJoints (1).empty());
  EXPECT_THAT (::testing::internal::GetCapturedStderr(), HasSubstr ("getJoints"));
  // A grid in one of the targets: which way is meant is not clear.
  targets[1]->width = 50;
  targets[1]->height = kPoints / 50;
  const auto organized = pcl::make_shared<Cloud> (*source);
  organized->width = 50;
  organized->height = kPoints / 50;
  registration.setInputSource (organized);
  setTargets();
  EXPECT_THAT (refusal(), HasSubstr ("not organized"));
  registration.setCorrespondence (CorrespondenceMethod::NearestNeighbor);
  Cloud warped;
  registration.align (warped);
  EXPECT_TRUE (registration.hasConverged()) << registration.getReport().message;
}

} // namespace
