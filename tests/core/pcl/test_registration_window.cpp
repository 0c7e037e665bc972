// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cstring>
#include <limits>

// Several targets: what belongs to pairs of frames and of segments, and misuse.

namespace {

using namespace pcl_msf;
using ::testing::HasSubstr;

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;
using Registration = PiecewiseRigidRegistration<pcl::PointXYZRGB>;

/** The scene after k small motions. */
Cloud::Ptr
view (int k)
{
  RigidPose step = RigidPair::motion();
  for (double& parameter : step.parameters)
    parameter *= 0.5;
  RigidPose pose;
  for (int i = 0; i < k; ++i)
    pose = step * pose;
  return RigidPair::view (pose);
}

bool
sameBits (const cv::Mat& a, const cv::Mat& b)
{
  return !a.empty() && a.size() == b.size() &&
         std::memcmp (a.data, b.data, a.total() * a.elemSize()) == 0;
}

Cloud::Ptr
blind ()
{
  auto cloud = pcl::make_shared<Cloud> (*view (1));
  for (auto& point : *cloud)
    point.x = point.y = point.z = std::numeric_limits<float>::quiet_NaN();
  cloud->is_dense = false;
  return cloud;
}

std::string
refusal (const std::vector<Cloud::ConstPtr>& targets)
{
  Registration registration;
  registration.setInputSource (view (0));
  registration.setInputTargets (targets);
  Cloud warped;
  registration.align (warped);
  EXPECT_FALSE (registration.hasConverged());
  EXPECT_EQ (registration.getReport().stop_reason, StopReason::InvalidInput);
  EXPECT_TRUE (registration.getWarpedCloud (1).empty());
  return registration.getReport().message;
}

TEST (RegistrationWindow, TargetsOneByOneAreTheList)
{
  Registration single, list;
  Cloud warped;
  single.setInputSource (view (0));
  list.setInputSource (view (0));
  single.addInputTarget (view (5));
  single.clearInputTargets();
  single.addInputTarget (view (1));
  single.addInputTarget (view (2));
  list.setInputTargets ({view (1), view (2)});
  single.align (warped);
  list.align (warped);
  ASSERT_TRUE (single.hasConverged() && list.hasConverged());
  for (const int frame : {1, 2})
    EXPECT_TRUE (
        sameBits (single.getSceneFlow (frame).flow, list.getSceneFlow (frame).flow));
  single.setInputTarget (view (1));
  EXPECT_EQ (single.getInputTargets().size(), 1U) << "replaces the list";
}

/** Where a pose takes a point of the first frame, from the truth. */
double
errorAt (const Eigen::Matrix4f& matrix, int from, int to)
{
  RigidPose step = RigidPair::motion();
  for (double& parameter : step.parameters)
    parameter *= 0.5;
  const auto move = [&] (Eigen::Vector3d p, int times) {
    for (int i = 0; i < std::abs (times); ++i)
      p = (times > 0 ? step : step.inverse()) * p;
    return p;
  };
  const Eigen::Vector3d p = move ({0.1, -0.1, 1.5}, from);
  return (RigidPose::fromMatrix (matrix) * p - move (p, to - from)).norm();
}

TEST (RegistrationWindow, EveryPairHasPosesThatAreTrue)
{
  Registration registration;
  registration.setInputSource (view (1));
  registration.setInputTargets ({view (0), view (2), view (3)});
  registration.setReferenceFrame (1);
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << registration.getReport().message;
  EXPECT_EQ (registration.getMultiframeSceneFlow().motions.size(), 6U);
  for (int from = 0; from < 4; ++from)
    for (int to = 0; to < 4; ++to)
      EXPECT_LT (errorAt (registration.getPose (from, to, 0), from, to), 0.01)
          << from << " to " << to;
  for (const int frame : {0, 2, 3})
    EXPECT_FALSE (registration.getSceneFlow (frame).pairs.empty()) << frame;
}

TEST (RegistrationWindow, BehindTheBasePointerTheLastTargetCounts)
{
  Registration registration;
  registration.setInputTargets ({view (1), view (2)});
  pcl::Registration<pcl::PointXYZRGB, pcl::PointXYZRGB>& base = registration;
  base.setInputSource (view (0));
  Cloud warped;
  base.align (warped);
  ASSERT_TRUE (base.hasConverged());
  const Cloud last = registration.getWarpedCloud (2);
  ASSERT_EQ (last.size(), warped.size());
  for (std::size_t i = 0; i < last.size(); i += 97)
    EXPECT_EQ (std::memcmp (last[i].data, warped[i].data, 3 * sizeof (float)), 0);
  EXPECT_TRUE (base.getFinalTransformation().isApprox (
      registration.getSceneFlow (2).dominant_motion.matrix()));
  base.setInputTarget (view (1));
  base.align (warped);
  ASSERT_TRUE (base.hasConverged());
  EXPECT_EQ (registration.getMultiframeSceneFlow().frames.size(), 2U);
}

TEST (RegistrationWindow, ResultsBelongToTheCloudsThatWereAligned)
{
  Registration registration;
  registration.setInputSource (view (0));
  const Cloud::Ptr target = view (1);
  registration.setInputTargets ({target, view (2)});
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged());
  const Eigen::Vector3f before =
      registration.getWarpedCloud (1) (80, 60).getVector3fMap();
  registration.setInputSource (view (3));
  registration.clearInputTargets();
  *target = *view (4);
  EXPECT_EQ (registration.getWarpedCloud (1) (80, 60).getVector3fMap(), before);
  registration.setInputSource (view (0));
  registration.setInputTargets ({target, view (5)});
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << "the target's new points are used";
  EXPECT_GT (
      (registration.getWarpedCloud (1) (80, 60).getVector3fMap() - before).norm(),
      0.01F);
}

TEST (RegistrationWindow, AsksForFramesThatThereAreNoneOf)
{
  Registration registration;
  EXPECT_TRUE (registration.getSceneFlow (0).flow.empty());
  EXPECT_TRUE (registration.getWarpedCloud (0).empty());
  EXPECT_TRUE (registration.getPose (0, 0, 0).isIdentity());
  registration.setInputSource (view (0));
  registration.setInputTargets ({view (1), view (2)});
  Cloud warped;
  registration.align (warped);
  for (const int frame : {-1, 3}) {
    EXPECT_TRUE (registration.getSceneFlow (frame).flow.empty());
    EXPECT_TRUE (registration.getWarpedCloud (frame).empty());
    EXPECT_TRUE (registration.getPose (0, frame, 0).isIdentity());
  }
  EXPECT_TRUE (registration.getPose (0, 1, -1).isIdentity());
  EXPECT_TRUE (registration.getPose (0, 1, 100000).isIdentity());
}

TEST (RegistrationWindow, NamesTheTargetThatDoesNotFit)
{
  EXPECT_THAT (refusal ({view (1), pcl::make_shared<Cloud> (80, 60)}),
               HasSubstr ("target 2 of 2 80x60"));
  EXPECT_THAT (refusal ({view (1), blind(), view (2)}),
               HasSubstr ("target 2 of 3 has a valid depth"));
  const auto row = pcl::make_shared<Cloud> (*view (1));
  row->width = row->size();
  row->height = 1;
  EXPECT_THAT (refusal ({row, view (1)}), HasSubstr ("target 1 of 2"));
}

TEST (RegistrationWindow, NineFramesAreNotTooMany)
{
  Registration registration;
  registration.setInputSource (view (0));
  MultiframeParameters near;
  near.max_span = 1;
  registration.setMultiframeParameters (near);
  registration.setSegmentationMethod (SegmentationMethod::Single);
  for (int k = 1; k < 9; ++k)
    registration.addInputTarget (view (k));
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << registration.getReport().message;
  EXPECT_LT (errorAt (registration.getFinalTransformation(), 0, 8), 0.01);
  EXPECT_EQ (registration.getMultiframeSceneFlow().frames.size(), 9U);
}

} // namespace
