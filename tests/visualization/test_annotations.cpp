// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "visualization/annotations.h"
#include "visualization/layer_sum.h"
#include <pcl_msf/visualization/picture_sheet.h>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::visualization;

const cv::Vec3b kWhite (255, 255, 255);
const cv::Vec3b kRed (0, 0, 255);
const cv::Vec3b kBlue (255, 0, 0);

/** Pixels that are not black. */
int
drawn (const cv::Mat& picture)
{
  cv::Mat plain;
  cv::inRange (picture, cv::Scalar::all (0), cv::Scalar::all (0), plain);
  return static_cast<int> (picture.total()) - cv::countNonZero (plain);
}

/** A black picture with the annotations of a style; needs no window. */
cv::Mat
annotated (const PictureStyle& style, bool parallel = false)
{
  Scene scene;
  scene.title = "title";
  scene.legend = {{kRed, "red things"}};
  scene.scale = ColorScale{0.0, 2.0, "length [m]", 2};
  cv::Mat picture (style.size, CV_8UC3, cv::Scalar::all (0));
  View view = sensorView ({300, 300, 160, 120}, style.size);
  if (parallel)
    view = parallelView (view, 1.0); // 300 pixels per metre
  annotate (picture, scene, view, style);
  return picture;
}

PictureStyle
bareStyle ()
{
  PictureStyle style;
  style.size = {320, 240};
  style.background = {0, 0, 0};
  style.axes = style.legend = style.title = false;
  return style;
}

TEST (Annotations, NoneWhenAllAreOff)
{
  EXPECT_EQ (drawn (annotated (bareStyle())), 0);
}

TEST (Annotations, TitleIsInTheUpperLeftCorner)
{
  PictureStyle style = bareStyle();
  style.title = true;
  const cv::Mat picture = annotated (style);
  EXPECT_GT (drawn (picture (cv::Rect (0, 0, 100, 30))), 20);
  EXPECT_EQ (drawn (picture.rowRange (40, 240)), 0);
}

TEST (Annotations, LegendHasSwatchesAndTheScaleItsBar)
{
  PictureStyle style = bareStyle();
  style.legend = true;
  const cv::Mat picture = annotated (style);
  cv::Mat red;
  cv::inRange (picture, cv::Scalar (kRed), cv::Scalar (kRed), red);
  EXPECT_GT (cv::countNonZero (red (cv::Rect (0, 0, 40, 40))), 15);
  EXPECT_GT (drawn (picture (cv::Rect (200, 190, 120, 50))), 200);
}

TEST (Annotations, AnOpenScaleSaysSo)
{
  Scene scene;
  scene.scale = ColorScale{0.0, 2.0, "", 2};
  PictureStyle style = bareStyle();
  style.legend = true;
  const View view = sensorView ({300, 300, 160, 120}, style.size);
  cv::Mat closed (style.size, CV_8UC3, cv::Scalar::all (0));
  annotate (closed, scene, view, style);
  scene.scale->open = true;
  cv::Mat open (style.size, CV_8UC3, cv::Scalar::all (0));
  annotate (open, scene, view, style);
  cv::Mat difference;
  cv::absdiff (open, closed, difference);
  EXPECT_GT (drawn (difference), 10) << "the sign before the last number";
}

TEST (Annotations, AxesAreInTheLowerLeftCornerWithALengthWhenParallel)
{
  PictureStyle style = bareStyle();
  style.axes = true;
  const cv::Mat axes = annotated (style);
  EXPECT_GT (drawn (axes (cv::Rect (0, 190, 60, 50))), 20);
  EXPECT_EQ (drawn (axes (cv::Rect (120, 0, 200, 240))), 0);
  // A fifth of 320 pixels is 0.21 m: the bar is 0.2 m long, 60 pixels.
  const cv::Mat parallel = annotated (style, true);
  int longest = 0;
  for (int row = 200; row < 240; ++row) {
    int run = 0;
    for (int col = 0; col < 320; ++col) {
      run =
          parallel.at<cv::Vec3b> (row, col) == cv::Vec3b (240, 240, 240) ? run + 1 : 0;
      longest = std::max (longest, run);
    }
  }
  EXPECT_EQ (longest, 60);
}

TEST (Annotations, SmallPicturesAreNoProblem)
{
  PictureStyle style;
  style.size = {16, 16};
  EXPECT_NO_THROW (annotated (style));
}

TEST (LayerSum, AveragesByCoverage)
{
  LayerSum sum (kWhite);
  cv::Mat first (1, 3, CV_8UC4, cv::Scalar (0, 0, 255, 255));
  first.at<cv::Vec4b> (0, 2) = {255, 255, 255, 0};
  cv::Mat second (1, 3, CV_8UC4, cv::Scalar (255, 0, 0, 255));
  second.at<cv::Vec4b> (0, 1) = {255, 255, 255, 0};
  second.at<cv::Vec4b> (0, 2) = {255, 128, 128, 127}; // half covered by blue
  sum.add (first);
  sum.add (second);
  const cv::Mat mean = sum.mean();
  EXPECT_NEAR (mean.at<cv::Vec3b> (0, 0)[0], 128, 1);
  EXPECT_NEAR (mean.at<cv::Vec3b> (0, 0)[2], 128, 1);
  EXPECT_EQ (mean.at<cv::Vec3b> (0, 1), kRed);
  EXPECT_NEAR (mean.at<cv::Vec3b> (0, 2)[1], 128, 1) << "the background shines through";
}

TEST (Annotations, RoundLengths)
{
  EXPECT_DOUBLE_EQ (roundLength (0.79), 0.5);
  EXPECT_DOUBLE_EQ (roundLength (2.5), 2.0);
  EXPECT_DOUBLE_EQ (roundLength (10.0), 10.0);
  EXPECT_DOUBLE_EQ (roundLength (0.019), 0.01);
}

TEST (PictureSheet, TilesRowByRow)
{
  const cv::Mat red (30, 40, CV_8UC3, cv::Scalar (kRed));
  const cv::Mat blue (60, 80, CV_8UC3, cv::Scalar (kBlue));
  const cv::Mat sheet = pictureSheet ({red, blue, red}, 2, kWhite);
  EXPECT_EQ (sheet.size(), cv::Size (84, 64));
  EXPECT_EQ (sheet.at<cv::Vec3b> (10, 10), kRed);
  EXPECT_EQ (sheet.at<cv::Vec3b> (10, 60), kBlue);
  EXPECT_EQ (sheet.at<cv::Vec3b> (50, 10), kRed);
  EXPECT_EQ (sheet.at<cv::Vec3b> (50, 60), kWhite);
}

} // namespace
