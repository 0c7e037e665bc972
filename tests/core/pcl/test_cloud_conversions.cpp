// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/common/io.h>

#include <gtest/gtest.h>

#include "support/rigid_pair.h"
#include <gmock/gmock.h>
#include <pcl_msf/cloud_conversions.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/lazy_kd_tree.h>

#include <cmath>

namespace {

using namespace pcl_msf;

TEST (CloudConversions, PointsWithoutAMeasurementAreNaN)
{
  pcl::PointCloud<pcl::PointXYZ> cloud (3, 2);
  cloud (0, 0) = {0.1f, 0.2f, 1.5f};
  cloud (1, 0) = {NAN, 0.0f, 1.0f};
  cloud (2, 0) = {0.0f, 0.0f, 0.0f};
  cloud (0, 1) = {0.0f, 0.0f, -1.0f};
  cloud (1, 1) = {0.0f, 0.0f, INFINITY};
  cloud (2, 1) = {0.3f, 0.4f, 2.5f};
  const cv::Mat points = pointImage (cloud);
  const cv::Mat depth = depthImage (points);
  ASSERT_EQ (points.type(), CV_32FC3);
  ASSERT_EQ (depth.type(), CV_32FC1);
  EXPECT_EQ (points.at<cv::Vec3f> (0, 0), cv::Vec3f (0.1f, 0.2f, 1.5f));
  EXPECT_EQ (depth.at<float> (1, 2), 2.5f);
  for (const cv::Point hole : {cv::Point (1, 0), {2, 0}, {0, 1}, {1, 1}}) {
    EXPECT_TRUE (std::isnan (depth.at<float> (hole)));
    EXPECT_TRUE (std::isnan (points.at<cv::Vec3f> (hole)[0]));
  }
}

TEST (CloudConversions, ColorComesFromWhicheverFieldThereIs)
{
  pcl::PointCloud<pcl::PointXYZRGB> rgb (2, 2);
  rgb (1, 0).r = 10;
  rgb (1, 0).g = 20;
  rgb (1, 0).b = 30;
  EXPECT_EQ (colorImage (rgb).at<cv::Vec3b> (0, 1), cv::Vec3b (30, 20, 10));
  pcl::PointCloud<pcl::PointXYZRGBA> rgba;
  pcl::copyPointCloud (rgb, rgba);
  EXPECT_EQ (colorImage (rgba).at<cv::Vec3b> (0, 1), cv::Vec3b (30, 20, 10));
  pcl::PointCloud<pcl::PointXYZRGBNormal> with_normal;
  pcl::copyPointCloud (rgb, with_normal);
  EXPECT_EQ (colorImage (with_normal).at<cv::Vec3b> (0, 1), cv::Vec3b (30, 20, 10));
  pcl::PointCloud<pcl::PointXYZI> gray (2, 2);
  gray (0, 1).intensity = 0.5f;
  gray (1, 1).intensity = NAN;
  EXPECT_EQ (colorImage (gray).at<float> (1, 0), 0.5f);
  EXPECT_EQ (colorImage (gray).at<float> (1, 1), 0.0f);
  EXPECT_TRUE (colorImage (pcl::PointCloud<pcl::PointXYZ> (2, 2)).empty());
}

TEST (CloudConversions, IntensitiesShareOneUnit)
{
  const auto normalized = [] (float a, float b) {
    cv::Mat first (1, 1, CV_32FC1, cv::Scalar (a));
    cv::Mat second (1, 1, CV_32FC1, cv::Scalar (b));
    normalizeIntensity (first, second);
    return std::make_pair (first.at<float> (0), second.at<float> (0));
  };
  EXPECT_EQ (normalized (0.25f, 1.0f), std::make_pair (0.25f, 1.0f));
  EXPECT_EQ (normalized (0.0f, 255.0f), std::make_pair (0.0f, 1.0f));
  EXPECT_EQ (normalized (63.75f, 0.0f), std::make_pair (0.25f, 0.0f));
  EXPECT_EQ (normalized (500.0f, 1023.0f), std::make_pair (500.0f / 1023.0f, 1.0f));
  EXPECT_EQ (normalized (70000.0f, 65535.0f).second, 65535.0f / 131071.0f);
  EXPECT_EQ (normalized (0.5f, 1.5f), std::make_pair (0.25f, 0.75f));
  EXPECT_EQ (normalized (-3.0f, 1.0f), std::make_pair (0.0f, 1.0f));
  EXPECT_EQ (normalized (NAN, INFINITY), std::make_pair (0.0f, 0.0f));
}

TEST (CloudConversions, SharesOfOneBesideBytesAreRefused)
{
  cv::Mat shares (8, 8, CV_32FC1, cv::Scalar (0.75));
  cv::Mat bytes (8, 8, CV_32FC1, cv::Scalar (191.0));
  cv::Mat dark (8, 8, CV_32FC1, cv::Scalar (1.0)); // the lights are out
  EXPECT_EQ (intensityUnit ({&bytes, &dark}), 255.0);
  try {
    intensityUnit ({&shares, &bytes});
    FAIL();
  }
  catch (const InvalidInput& error) {
    EXPECT_STREQ (error.what(),
                  "intensity: image 0 stays below 0.75, image 1 reaches 191; give all "
                  "that are compared in one unit");
  }
}

TEST (CloudConversions, HighlightsHaveNoSayInTheUnit)
{
  for (const double unit : {1.0, 255.0, 4095.0}) {
    cv::Mat plain (30, 40, CV_32FC1, cv::Scalar (0.75 * unit));
    plain.row (0).setTo (-1.0);
    plain.row (1).setTo (NAN); // not measured
    cv::Mat bright = plain.clone();
    bright (cv::Rect (5, 5, 7, 7)).setTo (40.0 * unit);
    EXPECT_EQ (intensityUnit ({&plain, &bright}), unit);
    normalizeIntensity (plain, bright);
    EXPECT_FLOAT_EQ (plain.at<float> (20, 20), 0.75f);
    EXPECT_EQ (bright.at<float> (20, 20), plain.at<float> (20, 20));
    EXPECT_EQ (bright.at<float> (6, 6), 1.0f);
    EXPECT_EQ (bright.at<float> (0, 0), 0.0f);
    EXPECT_EQ (bright.at<float> (1, 0), 0.0f);
  }
}

TEST (CloudConversions, ImagesInTheUsualUnitsKeepTheirBits)
{
  cv::Mat first (30, 40, CV_32FC1);
  cv::Mat second (30, 40, CV_32FC1);
  for (const double top : {1.0, 255.0}) {
    cv::randu (first, 0.0, 0.7 * top);
    cv::randu (second, 0.0, top);
    second.at<float> (3, 3) = static_cast<float> (top);
    cv::Mat a = first.clone();
    cv::Mat b = second.clone();
    normalizeIntensity (a, b);
    EXPECT_EQ (cv::countNonZero (a != cv::Mat (first / top)), 0);
    EXPECT_EQ (cv::countNonZero (b != cv::Mat (second / top)), 0);
  }
}

TEST (CloudConversions, LabelsAndNormals)
{
  pcl::PointCloud<pcl::Label> labels (2, 2);
  labels (0, 0).label = 0;
  labels (1, 0).label = 41;
  labels (0, 1).label = std::numeric_limits<std::uint32_t>::max();
  const cv::Mat image = labelImage (labels);
  EXPECT_EQ (image.at<int> (0, 0), 0);
  EXPECT_EQ (image.at<int> (0, 1), 41);
  EXPECT_EQ (image.at<int> (1, 0), -1);
  const pcl::PointCloud<pcl::Normal> normals (3, 2, pcl::Normal (0.0f, 0.6f, -0.8f));
  EXPECT_EQ (normalImage (normals).at<cv::Vec3f> (1, 2), cv::Vec3f (0.0f, 0.6f, -0.8f));
}

TEST (CloudConversions, UnorganizedCloudsAreRefused)
{
  EXPECT_THROW (pointImage (pcl::PointCloud<pcl::PointXYZ> (6, 1)), InvalidInput);
  EXPECT_THROW (colorImage (pcl::PointCloud<pcl::PointXYZ>()), InvalidInput);
  EXPECT_THROW (labelImage (pcl::PointCloud<pcl::Label> (6, 1)), InvalidInput);
  EXPECT_THROW (normalImage (pcl::PointCloud<pcl::Normal> (6, 1)), InvalidInput);
  pcl::PointCloud<pcl::PointXYZ> torn (3, 2);
  torn.points.resize (5);
  EXPECT_THROW (pointImage (torn), InvalidInput);
}

TEST (CloudConversions, TheCameraOfACloudIsFound)
{
  const auto cloud = RigidPair::reference();
  for (std::size_t i = 0; i < cloud->size(); i += 3)
    (*cloud)[i].z = NAN;
  PinholeCamera camera;
  ASSERT_TRUE (estimateCamera (pointImage (*cloud), camera));
  const PinholeCamera truth = RigidPair::camera();
  EXPECT_NEAR (camera.fx, truth.fx, 1e-3); // float coordinates
  EXPECT_NEAR (camera.fy, truth.fy, 1e-3);
  EXPECT_NEAR (camera.cx, truth.cx, 1e-3);
  EXPECT_NEAR (camera.cy, truth.cy, 1e-3);
  EXPECT_LT (projectionError (pointImage (*cloud), truth), 1e-3);
}

TEST (CloudConversions, CloudsThatFixNoCameraSayWhy)
{
  const auto upwards = RigidPair::reference();
  for (auto& p : *upwards)
    p.y = -p.y;
  const auto turned = RigidPair::reference();
  for (auto& p : *turned)
    p.getVector3fMap() =
        RigidPose{{0.0, 0.0, 0.5, 0.0, 0.0, 0.0}}.matrix().block<3, 3> (0, 0) *
        p.getVector3fMap();
  const pcl::PointCloud<pcl::PointXYZRGB> zeros (20, 10);
  for (const auto& cloud : {*upwards, *turned, zeros}) {
    PinholeCamera camera{1.0, 2.0, 3.0, 4.0};
    std::string why;
    EXPECT_FALSE (estimateCamera (pointImage (cloud), camera, &why));
    EXPECT_FALSE (why.empty());
    EXPECT_EQ (camera.fx, 1.0);
  }
}

TEST (LazyKdTree, BuildsOnTheFirstQueryAndFindsWhatPclFinds)
{
  const auto cloud = RigidPair::reference();
  (*cloud)[7].x = NAN;
  cloud->is_dense = false;
  LazyKdTree<pcl::PointXYZRGB> lazy;
  pcl::search::KdTree<pcl::PointXYZRGB> eager;
  lazy.setInputCloud (cloud);
  eager.setInputCloud (cloud);
  EXPECT_FALSE (lazy.isBuilt());
  EXPECT_EQ (lazy.getInputCloud(), cloud);
  pcl::Indices lazy_indices, eager_indices;
  std::vector<float> lazy_distances, eager_distances;
  EXPECT_EQ (lazy.nearestKSearch ((*cloud)[100], 4, lazy_indices, lazy_distances), 4);
  eager.nearestKSearch ((*cloud)[100], 4, eager_indices, eager_distances);
  EXPECT_TRUE (lazy.isBuilt());
  EXPECT_EQ (lazy_indices, eager_indices);
  EXPECT_EQ (lazy_distances, eager_distances);
  lazy.radiusSearch ((*cloud)[100], 0.05, lazy_indices, lazy_distances);
  eager.radiusSearch ((*cloud)[100], 0.05, eager_indices, eager_distances);
  EXPECT_EQ (lazy_indices, eager_indices);
  lazy.setInputCloud (cloud);
  EXPECT_FALSE (lazy.isBuilt());
}

TEST (LazyKdTree, QueriesWithoutAnAnswerFindNothing)
{
  const auto nothing = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (
      3, 2, pcl::PointXYZ (NAN, NAN, NAN));
  LazyKdTree<pcl::PointXYZ> tree;
  pcl::Indices indices;
  std::vector<float> distances;
  EXPECT_EQ (tree.nearestKSearch (pcl::PointXYZ(), 1, indices, distances), 0);
  tree.setInputCloud (nothing);
  EXPECT_EQ (tree.nearestKSearch (pcl::PointXYZ(), 1, indices, distances), 0);
  EXPECT_EQ (distances.at (0), INFINITY);
  EXPECT_EQ (tree.radiusSearch (pcl::PointXYZ(), 1.0, indices, distances), 0);
  tree.setInputCloud (pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (2, 2));
  EXPECT_EQ (
      tree.nearestKSearch (pcl::PointXYZ (NAN, 0.0f, 0.0f), 1, indices, distances), 0);
  EXPECT_EQ (distances.at (0), INFINITY);
  EXPECT_EQ (tree.nearestKSearch (pcl::PointXYZ(), 1, indices, distances), 1);
}

TEST (LazyKdTree, WithAQueryCameraPointsWithoutDepthDoNotCount)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->assign ({{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 2.0f}, {1.0f, 0.0f, -2.0f}}, 3);
  LazyKdTree<pcl::PointXYZ> tree;
  tree.setInputCloud (cloud);
  pcl::Indices indices;
  std::vector<float> distances;
  const pcl::PointXYZ query (0.1f, 0.0f, 0.1f);
  tree.nearestKSearch (query, 1, indices, distances);
  EXPECT_EQ (indices.at (0), 0) << "any point";
  Eigen::Matrix4f pose = Eigen::Matrix4f::Identity();
  tree.setQueryCamera (pose);
  EXPECT_FALSE (tree.isBuilt());
  EXPECT_EQ (tree.nearestKSearch (query, 3, indices, distances), 1);
  EXPECT_EQ (indices.at (0), 1);
  EXPECT_EQ (tree.radiusSearch (query, 1.0, indices, distances), 0);
  pose.col (3) << 0.1f, 0.0f, 0.1f, 1.0f; // the query is where its camera stood
  tree.setQueryCamera (pose);
  EXPECT_EQ (tree.nearestKSearch (query, 1, indices, distances), 0);
  EXPECT_EQ (distances.at (0), INFINITY);
  EXPECT_EQ (tree.radiusSearch (query, 9.0, indices, distances), 0);
  tree.clearQueryCamera();
  EXPECT_EQ (tree.nearestKSearch (query, 3, indices, distances), 3) << "as at first";
}

TEST (LazyKdTree, KeepsItsSettingsAndCopiesThem)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (
      3, 1, pcl::PointXYZ (0.0f, 0.0f, 1.0f));
  const auto chosen = pcl::make_shared<pcl::Indices> (pcl::Indices{1, 7});
  LazyKdTree<pcl::PointXYZ> tree;
  tree.setEpsilon (0.5f);
  tree.setInputCloud (cloud, chosen);
  pcl::Indices indices;
  std::vector<float> distances;
  EXPECT_EQ (tree.nearestKSearch ((*cloud)[0], 2, indices, distances), 1)
      << "7 is none";
  const auto copy = LazyKdTree<pcl::PointXYZ>::copyOf (tree);
  tree.setInputCloud (nullptr);
  EXPECT_EQ (tree.getEpsilon(), 0.5f);
  EXPECT_EQ (copy->getEpsilon(), 0.5f);
  EXPECT_FALSE (copy->isBuilt());
  EXPECT_EQ (copy->getIndices(), chosen);
  EXPECT_EQ (copy->nearestKSearch ((*cloud)[0], 2, indices, distances), 1);
  EXPECT_EQ (indices.at (0), 1);
}

} // namespace
