// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <pcl_msf/errors.h>
#include <pcl_msf/evaluation/residuals.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::evaluation;

const float kNan = std::numeric_limits<float>::quiet_NaN();
const PinholeCamera kCamera{10.0, 10.0, 0.0, 0.0};

cv::Mat
mask (const cv::Size& size)
{
  return {size, CV_8UC1, cv::Scalar (255)};
}

/** A ramp of 10 grey levels a pixel. */
cv::Mat
ramp (int offset)
{
  cv::Mat image (3, 8, CV_8UC1);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      image.at<unsigned char> (y, x) = static_cast<unsigned char> (10 * x + offset);
  return image;
}

TEST (PhotometricResiduals, InterpolatesBetweenPixels)
{
  // The current image has what was at x at x + 0.5; the last column looks beyond the
  // border, where 70 is replicated: 5 too little.
  const cv::Mat flow (3, 8, CV_32FC2, cv::Scalar (0.5, 0.0));
  const auto r = photometricResiduals (flow, ramp (5), ramp (0), mask (flow.size()));
  EXPECT_EQ (r.points, 24);
  EXPECT_NEAR (r.mean, 5.0 / 8.0, 1e-5);
  EXPECT_NEAR (r.median, 0.0, 1e-5);
}

TEST (PhotometricResiduals, UnknownFlowCountsAsZeroAndMaskSelects)
{
  const cv::Mat flow (3, 8, CV_32FC2, cv::Scalar::all (kNan));
  cv::Mat one (flow.size(), CV_8UC1, cv::Scalar (0));
  one.at<unsigned char> (1, 3) = 255;
  const auto r = photometricResiduals (flow, ramp (7), ramp (0), one);
  EXPECT_EQ (r.points, 1);
  EXPECT_NEAR (r.mean, 7.0, 1e-5);
  one = 0;
  EXPECT_TRUE (std::isnan (photometricResiduals (flow, ramp (7), ramp (0), one).mean));
}

TEST (PhotometricResiduals, OtherImagesAreRefused)
{
  const cv::Mat flow (3, 8, CV_32FC2, cv::Scalar (0.0, 0.0));
  const cv::Mat small (2, 2, CV_8UC1, cv::Scalar (0));
  EXPECT_THROW (photometricResiduals (flow, small, ramp (0), mask (flow.size())),
                InvalidInput);
}

TEST (DepthAt, BilinearInInverseDepthOnASurface)
{
  const cv::Mat depth = (cv::Mat_<float> (2, 2) << 2.0f, 2.04f, 2.0f, 2.04f);
  EXPECT_FLOAT_EQ (depthAt (depth, 0.0f, 0.0f), 2.0f);
  EXPECT_FLOAT_EQ (depthAt (depth, 0.5f, 0.5f), 1.0f / (0.25f + 0.5f / 2.04f));
}

TEST (DepthAt, NearestAcrossEdgesHolesAndAtTheBorder)
{
  const cv::Mat depth = (cv::Mat_<float> (2, 3) << 1.0f, 3.0f, 0.0f, 1.0f, 3.0f, kNan);
  EXPECT_FLOAT_EQ (depthAt (depth, 0.3f, 0.2f), 1.0f);
  EXPECT_FLOAT_EQ (depthAt (depth, 0.7f, 0.2f), 3.0f);
  EXPECT_FLOAT_EQ (depthAt (depth, 1.8f, 0.2f), 0.0f);
  EXPECT_FLOAT_EQ (depthAt (depth, 1.2f, 0.9f), 3.0f);
  EXPECT_FLOAT_EQ (depthAt (depth, -0.4f, 1.4f), 1.0f);
  EXPECT_FLOAT_EQ (depthAt (depth, -0.6f, 0.0f), 0.0f);
  EXPECT_FLOAT_EQ (depthAt (depth, 0.0f, 1.6f), 0.0f);
  EXPECT_FLOAT_EQ (depthAt (depth, kNan, 0.0f), 0.0f);
}

TEST (DepthResiduals, MetresAndSigmasByHand)
{
  // A wall at 2 m; points move to 2.02 m along their rays.
  const cv::Mat wall (4, 4, CV_32FC1, cv::Scalar (2.0));
  cv::Mat points (4, 4, CV_32FC3), motion (4, 4, CV_32FC3);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const Eigen::Vector3f p = kCamera.backProject (x, y, 2.0).cast<float>();
      points.at<cv::Vec3f> (y, x) = {p.x(), p.y(), p.z()};
      motion.at<cv::Vec3f> (y, x) = 0.01f * points.at<cv::Vec3f> (y, x);
    }
  const double noise = 1e-3;
  const auto r =
      depthResiduals (points, motion, wall, kCamera, noise, mask (wall.size()));
  EXPECT_EQ (r.points, 16);
  EXPECT_NEAR (r.mean, 0.02, 1e-6);
  EXPECT_NEAR (r.median, 0.02, 1e-6);
  EXPECT_NEAR (r.median_sigmas, (1 / 2.0 - 1 / 2.02) / noise, 1e-3);
  EXPECT_TRUE (std::isnan (
      depthResiduals (points, motion, wall, kCamera, 0.0, mask (wall.size()))
          .median_sigmas));
}

TEST (DepthResiduals, PointsThatLandNowhereAreLeftOut)
{
  const cv::Mat wall = (cv::Mat_<float> (1, 3) << 2.0f, 0.0f, 2.0f);
  const cv::Mat points = (cv::Mat_<cv::Vec3f> (1, 3) << cv::Vec3f (0, 0, 2),
                          cv::Vec3f (0.2f, 0, 2),
                          cv::Vec3f (0.4f, 0, 2));
  const cv::Mat motion = (cv::Mat_<cv::Vec3f> (1, 3) << cv::Vec3f (kNan, kNan, kNan),
                          cv::Vec3f (0, 0, 0),
                          cv::Vec3f (9, 0, 0));
  const auto r =
      depthResiduals (points, motion, wall, kCamera, 1e-3, mask (wall.size()));
  EXPECT_EQ (r.points, 1); // the first, as not moving
  EXPECT_DOUBLE_EQ (r.mean, 0.0);
}

} // namespace
