// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <gmock/gmock.h>
#include <pcl_msf/piecewise_rigid_registration.h>

#include <functional>
#include <limits>
#include <stdexcept>

// How an align ends that had good input: flags, stop reason, message.

namespace {

using namespace pcl_msf;
using testing::HasSubstr;

using Point = pcl::PointXYZRGB;
using Cloud = pcl::PointCloud<Point>;
using Registration = PiecewiseRigidRegistration<Point>;

TEST (Registration, ThrowingCallbacksDoNotEscape)
{
  Registration registration;
  registration.setInputSource (RigidPair::reference());
  registration.setInputTarget (RigidPair::current());
  Cloud output;
  SolverParameters solver;
  solver.progress = [] (const Progress&) -> bool {
    throw std::runtime_error ("from the callback");
  };
  registration.setSolverParameters (solver);
  testing::internal::CaptureStderr();
  EXPECT_NO_THROW (registration.align (output));
  EXPECT_THAT (testing::internal::GetCapturedStderr(), HasSubstr ("from the callback"));
  EXPECT_FALSE (registration.hasConverged());

  registration.setSolverParameters ({});
  bool armed = false;
  std::function<Registration::UpdateVisualizerCallbackSignature> callback =
      [&armed] (auto&, auto&, auto&, auto&) {
        if (armed)
          throw std::runtime_error ("from the visualizer");
      };
  registration.registerVisualizationCallback (callback);
  armed = true;
  testing::internal::CaptureStderr();
  EXPECT_NO_THROW (registration.align (output));
  EXPECT_THAT (testing::internal::GetCapturedStderr(),
               HasSubstr ("from the visualizer"));
  EXPECT_TRUE (registration.hasConverged()); // the result stands
}

TEST (Registration, CancellingEndsUnconvergedWithAReason)
{
  Registration registration;
  registration.setInputSource (RigidPair::reference());
  registration.setInputTarget (RigidPair::current());
  SolverParameters solver;
  solver.progress = [] (const Progress&) { return false; };
  registration.setSolverParameters (solver);
  Cloud output;
  registration.align (output);
  EXPECT_FALSE (registration.hasConverged());
  EXPECT_EQ (registration.getReport().stop_reason, StopReason::Cancelled);
}

TEST (Registration, ACoveredLensIsNoSuccessAndAllSaySo)
{
  const Cloud::Ptr lens = RigidPair::current();
  for (Point& p : *lens) {
    p.getVector3fMap() *= 0.3f / p.z;
    p.r = p.g = p.b = 20;
  }
  Registration registration;
  registration.setInputSource (RigidPair::reference());
  registration.setInputTarget (lens);
  Cloud output;
  testing::internal::CaptureStderr();
  registration.align (output);
  const std::string printed = testing::internal::GetCapturedStderr();
  const Report& report = registration.getReport();
  EXPECT_FALSE (registration.hasConverged());
  EXPECT_FALSE (report.converged);
  EXPECT_EQ (report.stop_reason, StopReason::NothingDetermined);
  ASSERT_NE (report.message, "");
  EXPECT_THAT (printed, HasSubstr (report.message));
  EXPECT_EQ (registration.getFinalTransformation(), Eigen::Matrix4f::Identity());
  EXPECT_EQ (registration.getFitnessScore(), std::numeric_limits<double>::max());
  ASSERT_EQ (output.size(), lens->size());
  for (const Point& p : output)
    ASSERT_FALSE (pcl::isXYZFinite (p)); // unknown is NaN
}

TEST (Registration, ATinyTimeBudgetEndsUnconvergedWithAResult)
{
  Registration registration;
  registration.setInputSource (RigidPair::reference());
  registration.setInputTarget (RigidPair::current());
  SolverParameters solver;
  solver.max_seconds = 1e-6;
  registration.setSolverParameters (solver);
  Cloud output;
  registration.align (output);
  EXPECT_FALSE (registration.hasConverged());
  EXPECT_EQ (registration.getReport().stop_reason, StopReason::TimeLimit);
  EXPECT_FALSE (registration.getSceneFlow().displacement.empty());
}

TEST (Registration, OneThatWasMovedFromIsEmptyAndCanBeUsedAgain)
{
  Registration registration;
  registration.setInputSource (RigidPair::reference());
  registration.setInputTarget (RigidPair::current());
  Cloud output;
  registration.align (output);
  const double fitness = registration.getFitnessScore();
  Registration moved (std::move (registration));
  EXPECT_TRUE (moved.hasConverged());
  EXPECT_EQ (moved.getFitnessScore(), fitness);
  registration = Registration();
  registration = std::move (moved);
  EXPECT_EQ (registration.getFitnessScore(), fitness);
  Registration& empty = moved; // NOLINT: that it may be used is the point
  EXPECT_FALSE (empty.hasConverged());
  EXPECT_FALSE (empty.getReport().converged);
  EXPECT_TRUE (empty.getCorrespondences().empty());
  EXPECT_TRUE (empty.getInputSource()->empty());
  EXPECT_TRUE (empty.getInputTarget()->empty());
  EXPECT_EQ (empty.getFinalTransformation(), Eigen::Matrix4f::Identity());
  testing::internal::CaptureStderr();
  empty.align (output);
  EXPECT_THAT (testing::internal::GetCapturedStderr(), HasSubstr ("setInputSource"));
  empty.setInputSource (RigidPair::reference());
  empty.setInputTarget (RigidPair::current());
  empty.align (output);
  EXPECT_EQ (empty.getFitnessScore(), fitness);
}

} // namespace
