// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "visualization/projection.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/visualization/view.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::visualization;

const PinholeCamera kCamera{500.0, 480.0, 300.0, 250.0};
const cv::Size kSize (640, 480);

void
expectPixel (const Eigen::Vector2d& found, double u, double v)
{
  EXPECT_NEAR (found.x(), u, 1e-6);
  EXPECT_NEAR (found.y(), v, 1e-6);
}

/** A scene of one metre around (0, 0, 3). */
SceneBounds
someBounds ()
{
  SceneBounds bounds;
  bounds.center = {0.0, 0.0, 3.0};
  bounds.radius = 1.0;
  bounds.distance = 3.0;
  return bounds;
}

TEST (Views, SensorSeesWhatTheCameraProjects)
{
  const View view = sensorView (kCamera, kSize);
  const Eigen::Vector3d point (0.3, -0.2, 2.0);
  expectPixel (view.project (point), 500 * 0.15 + 300, 480 * -0.1 + 250);
  EXPECT_TRUE (std::isnan (view.project ({0, 0, -1}).x())) << "behind the eye";
}

TEST (Views, ResizedKeepsTheMiddleAndTheShape)
{
  // Half the width, a quarter more height than that needs: scale 0.5. Pixel u covers
  // [u - 0.5, u + 0.5], so 300 becomes (300 + 0.5) / 2 - 0.5; rows move down by 30.
  const View view = sensorView (kCamera, kSize).resized ({320, 300});
  expectPixel (view.project ({0, 0, 1}), 149.75, 0.5 * 250.5 - 0.5 + 30);
  EXPECT_DOUBLE_EQ (view.camera.fx, 250.0);
  EXPECT_DOUBLE_EQ (view.camera.fy, 240.0);
}

TEST (Views, OrbitLooksAtTheCentreFromWhereItIsAsked)
{
  const View front = orbitView (someBounds(), kSize, 0.0, 0.0);
  expectPixel (front.project ({0, 0, 3}), 319.5, 239.5);
  EXPECT_LT (front.position.z(), 3.0);
  EXPECT_GT (front.project ({0.1, 0, 3}).x(), 319.5) << "x to the right";
  EXPECT_GT (front.project ({0, 0.1, 3}).y(), 239.5) << "y down";
  const View right = orbitView (someBounds(), kSize, 90.0, 0.0);
  EXPECT_GT (right.position.x(), 1.0);
  EXPECT_GT (right.project ({0, 0, 3.5}).x(), 319.5)
      << "far is to the right from there";
  const View above = orbitView (someBounds(), kSize, 0.0, 30.0);
  EXPECT_LT (above.position.y(), 0.0) << "y points down";
  EXPECT_NEAR (above.rotation.determinant(), 1.0, 1e-12);
}

TEST (Views, TopHasTheViewingDirectionUpwards)
{
  const View view = topView (someBounds(), kSize);
  expectPixel (view.project ({0, 0, 3}), 319.5, 239.5);
  EXPECT_LT (view.project ({0, 0, 3.5}).y(), 239.5);
  EXPECT_GT (view.project ({0.5, 0, 3}).x(), 319.5);
  EXPECT_NEAR (view.rotation.determinant(), 1.0, 1e-12);
}

TEST (Views, UserViewRefusesWhatHasNoDirection)
{
  EXPECT_THROW (userView ({0, 0, 1}, {0, 0, 1}, {0, -1, 0}, kSize), InvalidInput);
  EXPECT_THROW (userView ({0, 0, 1}, {0, 2, 1}, {0, -1, 0}, kSize), InvalidInput);
  const View view = userView ({1, 0, 0}, {1, 0, 4}, {0, -1, 0}, kSize, 60.0);
  expectPixel (view.project ({1, 0, 2}), 319.5, 239.5);
  EXPECT_NEAR (view.camera.fx, 320.0 / std::tan (30.0 * M_PI / 180.0), 1e-9);
}

TEST (Views, ParallelIsTheSameSizeAtItsDistanceAndAtAllOthers)
{
  const View perspective = sensorView (kCamera, kSize);
  const View parallel = parallelView (perspective, 2.0);
  EXPECT_DOUBLE_EQ (parallel.scale, 250.0);
  expectPixel (parallel.project ({0.1, 0.2, 2.0}), 325.0, 300.0);
  expectPixel (parallel.project ({0.1, 0.2, 9.0}), 325.0, 300.0);
}

TEST (Views, BoundsLeaveOutliersOut)
{
  cv::Mat points (1, 1000, CV_32FC3, cv::Scalar (0, 0, 2));
  for (int i = 0; i < 1000; ++i)
    points.at<cv::Vec3f> (0, i)[0] = static_cast<float> (i) / 999.0F;
  points.at<cv::Vec3f> (0, 0) = {500, 500, 500};
  points.at<cv::Vec3f> (0, 1) =
      cv::Vec3f::all (std::numeric_limits<float>::quiet_NaN());
  const SceneBounds bounds = boundsOf (points);
  EXPECT_NEAR (bounds.center.x(), 0.5, 0.02);
  EXPECT_NEAR (bounds.radius, 0.48, 0.02);
  EXPECT_GT (boundsOf (cv::Mat (1, 1, CV_32FC3, cv::Scalar (1, 2, 3))).radius, 0.0);
}

/** The matrix must send a point to the pixel that the view says. */
void
expectMatrixAgrees (const View& view)
{
  const Eigen::Vector3d point (0.3, -0.2, 2.5);
  const Eigen::Vector3d p = view.toView (point);
  const Eigen::Matrix4d matrix = projectionMatrix (view, {1.0, 4.0});
  const Eigen::Vector4d clip = matrix * Eigen::Vector4d (p.x(), -p.y(), -p.z(), 1.0);
  const Eigen::Vector3d device = clip.head<3>() / clip.w();
  expectPixel (view.project (point),
               0.5 * (device.x() + 1.0) * view.size.width - 0.5,
               0.5 * (1.0 - device.y()) * view.size.height - 0.5);
  EXPECT_LT (std::abs (device.z()), 1.0);
}

TEST (Views, ProjectionMatrixSendsPointsToTheirPixels)
{
  expectMatrixAgrees (sensorView (kCamera, kSize));
  expectMatrixAgrees (parallelView (sensorView (kCamera, kSize), 2.0));
  expectMatrixAgrees (orbitView (someBounds(), {200, 300}, 20.0, 10.0));
}

} // namespace
