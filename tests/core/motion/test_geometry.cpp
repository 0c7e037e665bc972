// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/rigid_pose.h>

#include <cmath>
#include <random>

namespace {

using namespace pcl_msf;

Eigen::Vector3d
randomVector (std::mt19937& generator, double scale)
{
  std::uniform_real_distribution<double> uniform (-scale, scale);
  return {uniform (generator), uniform (generator), uniform (generator)};
}

TEST (PinholeCamera, BackProjectionInvertsProjection)
{
  const PinholeCamera camera{525.0, 520.0, 319.5, 239.5};
  std::mt19937 generator (1);
  for (int i = 0; i < 100; ++i) {
    Eigen::Vector3d p = randomVector (generator, 2.0);
    p.z() += 3.0;
    const Eigen::Vector2d uv = camera.project (p);
    EXPECT_LT ((camera.backProject (uv.x(), uv.y(), p.z()) - p).norm(), 1e-12);
  }
}

TEST (PinholeCamera, HalvedCameraSeesPixelTwoIAtI)
{
  const PinholeCamera camera{525.0, 520.0, 319.5, 239.5};
  const Eigen::Vector3d p = camera.backProject (200.0, 100.0, 2.0);
  const Eigen::Vector2d uv = camera.halved().project (p);
  EXPECT_NEAR (uv.x(), 100.0, 1e-12);
  EXPECT_NEAR (uv.y(), 50.0, 1e-12);
}

TEST (PinholeCamera, RejectsAbsurdCamerasAndSaysWhy)
{
  const double nan = std::nan ("");
  for (const PinholeCamera& c : {PinholeCamera{},
                                 PinholeCamera{-525, 525, 320, 240},
                                 PinholeCamera{481.2, -480, 319.5, 239.5},
                                 PinholeCamera{nan, 525, 320, 240},
                                 PinholeCamera{525, 525, 32000, 240},
                                 PinholeCamera{1e9, 525, 320, 240}}) {
    std::string why;
    EXPECT_FALSE (c.isValid (640, 480, &why));
    EXPECT_NE (why.find ("focal lengths"), std::string::npos);
    EXPECT_EQ (why.find ("must be positive: flip") != std::string::npos,
               c.fx < 0.0 || c.fy < 0.0)
        << why;
  }
  EXPECT_TRUE ((PinholeCamera{525, 525, 320, 240}.isValid (640, 480)));
}

class RotationAngles : public testing::TestWithParam<double> {};

TEST_P (RotationAngles, ExponentialMatchesEigenAndLogarithmInverts)
{
  std::mt19937 generator (2);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d axis = randomVector (generator, 1.0).normalized();
    const Eigen::Vector3d a = GetParam() * axis;
    const Eigen::Matrix3d r = rotationFromVector (a);
    const Eigen::Matrix3d expected =
        Eigen::AngleAxisd (GetParam(), axis).toRotationMatrix();
    EXPECT_LT ((r - expected).norm(), 1e-12);
    EXPECT_LT ((rotationFromVector (vectorFromRotation (r)) - r).norm(), 1e-7);
    if (GetParam() < M_PI - 1e-3) {
      EXPECT_LT ((vectorFromRotation (r) - a).norm(), 1e-9);
    }
  }
}

TEST_P (RotationAngles, LeftJacobianMatchesFiniteDifferences)
{
  std::mt19937 generator (3);
  const Eigen::Vector3d a = GetParam() * randomVector (generator, 1.0).normalized();
  const Eigen::Vector3d p = randomVector (generator, 2.0);
  const Eigen::Matrix3d analytic =
      -skew (rotationFromVector (a) * p) * leftJacobian (a);
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = h * Eigen::Vector3d::Unit (i);
    const Eigen::Vector3d numeric =
        (rotationFromVector (a + step) * p - rotationFromVector (a - step) * p) /
        (2.0 * h);
    EXPECT_LT ((analytic.col (i) - numeric).norm(), 1e-8);
  }
}

INSTANTIATE_TEST_SUITE_P (
    All,
    RotationAngles,
    testing::Values (0.0, 1e-10, 1e-5, 1e-4, 0.001, 0.1, 1.5, 3.0, M_PI - 1e-6, M_PI));

TEST (RigidPose, CompositionAndInverse)
{
  std::mt19937 generator (4);
  for (int i = 0; i < 50; ++i) {
    const RigidPose b_from_a =
        RigidPose::fromMatrix (rotationFromVector (randomVector (generator, 1.5)),
                               randomVector (generator, 1.0));
    const RigidPose c_from_b =
        RigidPose::fromMatrix (rotationFromVector (randomVector (generator, 1.5)),
                               randomVector (generator, 1.0));
    const Eigen::Vector3d p = randomVector (generator, 3.0);
    EXPECT_LT (((c_from_b * b_from_a) * p - c_from_b * (b_from_a * p)).norm(), 1e-9);
    EXPECT_LT ((b_from_a.inverse() * (b_from_a * p) - p).norm(), 1e-9);
    EXPECT_LT ((RigidPose::fromMatrix (b_from_a.matrix()) * p - b_from_a * p).norm(),
               1e-5);
  }
}

} // namespace
