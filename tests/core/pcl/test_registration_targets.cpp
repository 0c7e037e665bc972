// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <pcl_msf/piecewise_rigid_registration.h>

#include <cstring>

namespace {

using namespace pcl_msf;

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;
using Registration = PiecewiseRigidRegistration<pcl::PointXYZRGB>;

/** The scene after k motions. */
Cloud::Ptr
view (int k)
{
  RigidPose pose;
  for (int i = 0; i < k; ++i)
    pose = RigidPair::motion() * pose;
  return RigidPair::view (pose);
}

double
errorAt (const Eigen::Matrix4f& matrix, int motions)
{
  const Eigen::Vector3d p (0.1, -0.1, 1.5);
  Eigen::Vector3d truth = p;
  for (int i = 0; i < std::abs (motions); ++i)
    truth = (motions > 0 ? RigidPair::motion() : RigidPair::motion().inverse()) * truth;
  return (RigidPose::fromMatrix (matrix) * p - truth).norm();
}

bool
sameBits (const cv::Mat& a, const cv::Mat& b)
{
  return a.size() == b.size() &&
         std::memcmp (a.data, b.data, a.total() * a.elemSize()) == 0;
}

TEST (RegistrationTargets, OneTargetOfAListIsATarget)
{
  Registration one, list;
  Cloud warped;
  one.setInputSource (view (0));
  one.setInputTarget (view (1));
  one.align (warped);
  list.setInputSource (view (0));
  list.addInputTarget (view (1));
  list.align (warped);
  ASSERT_TRUE (one.hasConverged() && list.hasConverged());
  EXPECT_TRUE (sameBits (one.getSceneFlow().flow, list.getSceneFlow (1).flow));
  EXPECT_LT (errorAt (list.getFinalTransformation(), 1), 0.005);
  EXPECT_LT (errorAt (list.getPose (1, 0, 0), -1), 0.005);
  EXPECT_EQ (list.getInputTargets().size(), 1U);
  EXPECT_TRUE (list.getSceneFlow (0).flow.empty());
}

TEST (RegistrationTargets, AlignsWithTheLastAndKnowsAll)
{
  Registration registration;
  registration.setInputSource (view (0));
  registration.setInputTargets ({view (1), view (2)});
  const pcl::Registration<pcl::PointXYZRGB, pcl::PointXYZRGB>& base = registration;
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << registration.getReport().message;
  EXPECT_LT (errorAt (registration.getFinalTransformation(), 2), 0.005);
  EXPECT_LT (errorAt (registration.getPose (0, 1, 0), 1), 0.02);
  EXPECT_TRUE (registration.getPose (0, 1, 0).isApprox (
      registration.getPose (1, 0, 0).inverse(), 1e-4F));
  EXPECT_LT (registration.getFitnessScore(), 1e-3);
  EXPECT_EQ (base.getClassName(), "PiecewiseRigidRegistration");
  const Cloud last = registration.getWarpedCloud (2);
  ASSERT_EQ (last.size(), warped.size());
  EXPECT_EQ (last (80, 60).x, warped (80, 60).x);
  const Cloud middle = registration.getWarpedCloud (1);
  const Eigen::Vector3d truth =
      RigidPair::motion() * (*view (0)) (80, 60).getVector3fMap().cast<double>();
  EXPECT_LT ((middle (80, 60).getVector3fMap().cast<double>() - truth).norm(), 0.01);
  EXPECT_EQ (registration.getMultiframeSceneFlow().motions.size(), 3U);
}

TEST (RegistrationTargets, ReferenceInTheMiddle)
{
  Registration registration;
  registration.setInputSource (view (1));
  registration.setInputTargets ({view (0), view (2)});
  registration.setReferenceFrame (1);
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged()) << registration.getReport().message;
  EXPECT_LT (errorAt (registration.getFinalTransformation(), 1), 0.005) << "the last";
  EXPECT_LT (errorAt (registration.getSceneFlow (0).dominant_motion.matrix(), -1),
             0.005);
  EXPECT_EQ (registration.getWarpedCloud (1).size(), warped.size()) << "the source";
}

TEST (RegistrationTargets, SingleIsOneSegment)
{
  Registration registration;
  registration.setInputSource (view (0));
  registration.setInputTargets ({view (1), view (2)});
  registration.setSegmentationMethod (SegmentationMethod::Single);
  Cloud warped;
  registration.align (warped);
  ASSERT_TRUE (registration.hasConverged());
  EXPECT_EQ (registration.getSceneFlow().segments.size(), 1U);
  EXPECT_LT (errorAt (registration.getFinalTransformation(), 2), 0.003);
}

TEST (RegistrationTargets, RefusesWhatDoesNotFit)
{
  Registration registration;
  registration.setInputSource (view (0));
  registration.setInputTargets ({view (1), view (2)});
  registration.addInputTarget (nullptr);
  EXPECT_EQ (registration.getInputTargets().size(), 2U) << "the others stay";
  registration.setReferenceFrame (-1);
  EXPECT_EQ (registration.getReferenceFrame(), 0);
  registration.setReferenceFrame (3);
  Cloud warped;
  registration.align (warped);
  EXPECT_FALSE (registration.hasConverged());
  EXPECT_EQ (registration.getReport().stop_reason, StopReason::InvalidInput);
  EXPECT_TRUE (registration.getSceneFlow().flow.empty());
  EXPECT_TRUE (registration.getWarpedCloud (1).empty());
  EXPECT_TRUE (registration.getPose (0, 7, 0).isIdentity());
  registration.setReferenceFrame (0);
  registration.setInputTargets ({view (1), pcl::make_shared<Cloud> (80, 60)});
  registration.align (warped);
  EXPECT_FALSE (registration.hasConverged()) << "another size";
  registration.setInputTargets ({view (1), nullptr});
  EXPECT_TRUE (registration.getInputTargets().empty());
  registration.clearInputTargets();
  registration.align (warped);
  EXPECT_FALSE (registration.hasConverged());
  MultiframeParameters bad;
  bad.max_span = -1;
  registration.setMultiframeParameters (bad);
  EXPECT_EQ (registration.getMultiframeParameters().max_span, 0);
}

TEST (RegistrationTargets, PointersToCloudsThatMayChangeAreTakenToo)
{
  Registration registration;
  const std::vector<Cloud::Ptr> changing{view (1), view (2)};
  registration.setInputTargets (changing);
  ASSERT_EQ (registration.getInputTargets().size(), 2U);
  EXPECT_EQ (registration.getInputTargets()[1], changing[1]);
  registration.setInputTargets ({changing[1]});
  EXPECT_EQ (registration.getInputTargets().size(), 1U);
}

} // namespace
