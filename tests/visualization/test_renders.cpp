// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/visualization/offscreen_renderer.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::visualization;

const cv::Size kSize (64, 48);
const PinholeCamera kCamera{60.0, 55.0, 30.0, 25.0};
const cv::Vec3b kWhite (255, 255, 255);
const cv::Vec3b kRed (0, 0, 255);
const cv::Vec3b kBlue (255, 0, 0);

/** One window for all tests: starting a display takes a while. */
OffscreenRenderer&
renderer ()
{
  static OffscreenRenderer the_renderer;
  return the_renderer;
}

PictureStyle
bareStyle ()
{
  PictureStyle style;
  style.size = kSize;
  style.point_size = 1.0;
  style.axes = style.legend = style.title = false;
  return style;
}

cv::Vec3f
pointAt (int col, int row, double depth)
{
  const Eigen::Vector3f p = kCamera.backProject (col, row, depth).cast<float>();
  return {p.x(), p.y(), p.z()};
}

PointSet
onePoint (int col, int row, double depth, const cv::Vec3b& color)
{
  PointSet set{cv::Mat (1, 1, CV_32FC3), cv::Mat (1, 1, CV_8UC3)};
  set.positions.at<cv::Vec3f> (0, 0) = pointAt (col, row, depth);
  set.colors.at<cv::Vec3b> (0, 0) = color;
  return set;
}

cv::Mat
render (const Scene& scene, const PictureStyle& style = bareStyle())
{
  return renderer().render (scene, sensorView (kCamera, kSize), style);
}

/** Pixels that differ from the background. */
int
drawn (const cv::Mat& picture, const cv::Vec3b& background = kWhite)
{
  cv::Mat plain;
  cv::inRange (picture, cv::Scalar (background), cv::Scalar (background), plain);
  return static_cast<int> (picture.total()) - cv::countNonZero (plain);
}

TEST (Renders, PointsLandOnTheirPixels)
{
  Scene scene;
  for (const auto& [col, row] : {std::pair (3, 4), {30, 25}, {60, 2}, {10, 44}, {0, 0}})
    scene.points.push_back (onePoint (col, row, 1.0 + 0.1 * col, kRed));
  const cv::Mat picture = render (scene);
  ASSERT_EQ (picture.size(), kSize);
  for (const auto& [col, row] : {std::pair (3, 4), {30, 25}, {60, 2}, {10, 44}, {0, 0}})
    EXPECT_EQ (picture.at<cv::Vec3b> (row, col), kRed) << col << ", " << row;
  EXPECT_EQ (drawn (picture), 5) << "nothing else";
}

TEST (Renders, NearPointsHideFarOnes)
{
  Scene scene;
  scene.points = {onePoint (20, 20, 1.0, kRed), onePoint (20, 20, 2.0, kBlue)};
  EXPECT_EQ (render (scene).at<cv::Vec3b> (20, 20), kRed);
  std::swap (scene.points[0], scene.points[1]);
  EXPECT_EQ (render (scene).at<cv::Vec3b> (20, 20), kRed);
}

TEST (Renders, BlendedCloudsAreAveragedWhereBothAre)
{
  Scene scene;
  scene.blended = true;
  scene.points = {onePoint (20, 20, 1.0, kRed), onePoint (20, 20, 2.0, kBlue)};
  scene.points[0].positions.push_back (pointAt (40, 20, 1.0));
  scene.points[0].colors.push_back (kRed);
  const cv::Mat picture = render (scene);
  EXPECT_NEAR (picture.at<cv::Vec3b> (20, 20)[0], 128, 2);
  EXPECT_NEAR (picture.at<cv::Vec3b> (20, 20)[2], 128, 2);
  EXPECT_EQ (picture.at<cv::Vec3b> (20, 40), kRed) << "alone";
  EXPECT_EQ (drawn (picture), 2);
}

TEST (Renders, TrianglesFillTheGapBetweenTheirPoints)
{
  PointSet set{cv::Mat (1, 3, CV_32FC3), cv::Mat (1, 3, CV_8UC3, cv::Scalar (kRed))};
  set.positions.at<cv::Vec3f> (0, 0) = pointAt (10, 10, 1.0);
  set.positions.at<cv::Vec3f> (0, 1) = pointAt (50, 10, 1.0);
  set.positions.at<cv::Vec3f> (0, 2) = pointAt (30, 40, 1.0);
  Scene scene;
  scene.points = {set};
  EXPECT_EQ (drawn (render (scene)), 3);
  scene.points[0].triangles = {{0, 1, 2}};
  EXPECT_NEAR (drawn (render (scene)), 40 * 30 / 2, 60);
  EXPECT_EQ (render (scene).at<cv::Vec3b> (20, 30), kRed);
  scene.points[0].positions.at<cv::Vec3f> (0, 1)[2] =
      std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ (drawn (render (scene)), 2) << "a corner is unknown";
  scene.points[0].triangles = {{0, 1, 3}};
  EXPECT_THROW (render (scene), InvalidInput);
}

TEST (Renders, UnknownPointsAreNotDrawn)
{
  Scene scene;
  scene.points = {onePoint (20, 20, 1.0, kRed)};
  scene.points[0].positions.at<cv::Vec3f> (0, 0)[1] =
      std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ (drawn (render (scene)), 0);
  EXPECT_EQ (drawn (render (Scene())), 0) << "an empty scene has a picture";
}

/** The golden image is computed: a tilted plane of two colours, seen through kCamera.
 */
TEST (Renders, PlaneLooksAsComputed)
{
  PointSet plane{cv::Mat (kSize, CV_32FC3), cv::Mat (kSize, CV_8UC3)};
  cv::Mat expected (kSize, CV_8UC3);
  for (int row = 0; row < kSize.height; ++row)
    for (int col = 0; col < kSize.width; ++col) {
      plane.positions.at<cv::Vec3f> (row, col) = pointAt (col, row, 1.5 + 0.02 * col);
      const bool left = (col / 8 + row / 8) % 2 == 0;
      expected.at<cv::Vec3b> (row, col) = left ? kRed : cv::Vec3b (40, 160, 90);
    }
  expected.copyTo (plane.colors);
  Scene scene;
  scene.points = {plane};
  PictureStyle style = bareStyle();
  style.point_size = 0.0; // automatic: no gaps, a little overlap
  for (const int supersampling : {1, 2, 4}) {
    style.supersampling = supersampling;
    const cv::Mat picture = render (scene, style);
    cv::Mat difference;
    cv::absdiff (picture, expected, difference);
    cv::Mat different;
    cv::inRange (difference, cv::Scalar::all (0), cv::Scalar::all (40), different);
    const double same = cv::countNonZero (different) / double (kSize.area());
    EXPECT_GT (same, 0.7) << supersampling << ": all but the edges of 8 pixel squares";
    EXPECT_LT (cv::mean (difference)[1], 25.0) << supersampling;
  }
}

TEST (Renders, ArrowsPointAlongTheDisplacement)
{
  Scene scene;
  scene.arrows = {{pointAt (12, 25, 1.0), pointAt (52, 25, 1.0), kBlue}};
  PictureStyle style = bareStyle();
  style.supersampling = 4;
  const cv::Mat picture = render (scene, style);
  EXPECT_NE (picture.at<cv::Vec3b> (25, 20), kWhite) << "shaft";
  EXPECT_EQ (picture.at<cv::Vec3b> (25, 8), kWhite) << "before its foot";
  EXPECT_EQ (picture.at<cv::Vec3b> (25, 56), kWhite) << "behind its tip";
  EXPECT_GT (drawn (picture.colRange (36, 46)), drawn (picture.colRange (16, 26)))
      << "the head is the thick part";
  const cv::Vec3b shaft = picture.at<cv::Vec3b> (25, 20);
  EXPECT_GT (shaft[0], shaft[2] + 50) << "blue";
}

TEST (Renders, LinesLieOverTheCloud)
{
  PointSet wall{cv::Mat (kSize, CV_32FC3),
                cv::Mat (kSize, CV_8UC3, cv::Scalar::all (9))};
  for (int row = 0; row < kSize.height; ++row)
    for (int col = 0; col < kSize.width; ++col)
      wall.positions.at<cv::Vec3f> (row, col) = pointAt (col, row, 2.0);
  Scene scene;
  scene.points = {wall};
  scene.lines = {{{pointAt (10, 20, 2.0), pointAt (50, 20, 2.0)}, {kRed, kRed}}};
  PictureStyle style = bareStyle();
  style.point_size = 2.0;
  const cv::Mat picture = render (scene, style);
  EXPECT_GT (picture.at<cv::Vec3b> (20, 30)[2], 150);
  EXPECT_LT (picture.at<cv::Vec3b> (30, 30)[2], 60);
  scene.lines[0].colors.pop_back();
  EXPECT_THROW (render (scene), InvalidInput);
}

TEST (Renders, ParallelViewIgnoresDepth)
{
  Scene scene;
  PointSet set{cv::Mat (1, 2, CV_32FC3), cv::Mat (1, 2, CV_8UC3, cv::Scalar (kRed))};
  set.positions.at<cv::Vec3f> (0, 0) = {0.1F, 0.2F, 1.0F};
  set.positions.at<cv::Vec3f> (0, 1) = {-0.1F, 0.2F, 7.0F};
  scene.points = {set};
  View view = parallelView (sensorView (kCamera, kSize), 1.2); // 50 pixels per metre
  const cv::Mat picture = renderer().render (scene, view, bareStyle());
  EXPECT_EQ (picture.at<cv::Vec3b> (35, 35), kRed);
  EXPECT_EQ (picture.at<cv::Vec3b> (35, 25), kRed);
  EXPECT_EQ (drawn (picture), 2);
}

TEST (Renders, LargePicturesAndBadStyles)
{
  Scene scene;
  scene.points = {onePoint (30, 25, 1.0, kRed)};
  PictureStyle style = bareStyle();
  style.size = {3840, 2160};
  style.supersampling = 1;
  EXPECT_EQ (render (scene, style).size(), style.size);
  const auto refused = [&scene] (const PictureStyle& bad) {
    EXPECT_THROW (render (scene, bad), InvalidInput);
  };
  style.supersampling = 8;
  refused (style);
  style = bareStyle();
  style.size = {4000, 100};
  refused (style);
  style = bareStyle();
  style.point_size = -1.0;
  refused (style);
  scene.points[0].colors = cv::Mat (2, 1, CV_8UC3);
  EXPECT_THROW (render (scene), InvalidInput);
  EXPECT_THROW (renderer().render (Scene(), View(), bareStyle()), InvalidInput);
}

} // namespace
