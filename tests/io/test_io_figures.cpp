// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <pcl_msf/io/figures.h>
#include <pcl_msf/io/flow_color.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;

const float kNan = std::numeric_limits<float>::quiet_NaN();

cv::Vec3b
colorOf (float u, float v, double maximum)
{
  const cv::Mat flow (1, 1, CV_32FC2, cv::Scalar (u, v));
  return io::flowColors (flow, maximum).at<cv::Vec3b> (0, 0);
}

/** Largest difference of a channel. */
int
distance (const cv::Vec3b& a, const cv::Vec3b& b)
{
  int largest = 0;
  for (int c = 0; c < 3; ++c)
    largest = std::max (largest, std::abs (int{a[c]} - int{b[c]}));
  return largest;
}

TEST (FlowColors, DirectionsHaveTheirHues)
{
  // Baker et al.: 15 hues from red to yellow, 6 to green, 4 to cyan, 11 to blue, 13 to
  // magenta, 6 back to red; right is red and the wheel turns with the image's angle. So
  // down, a quarter, is hue 13.5; left, a half, hue 27; up hue 40.5. One hue step is at
  // most 64 levels (green to cyan in four), a fifth of it is the tolerance.
  const int tolerance = 12;
  EXPECT_LE (distance (colorOf (5, 0, 5), {0, 0, 255}), tolerance) << "right: red";
  EXPECT_LE (distance (colorOf (0, 5, 5), {0, 230, 255}), tolerance) << "down: yellow";
  EXPECT_LE (distance (colorOf (-5, 0, 5), {255, 209, 0}), tolerance) << "left: cyan";
  EXPECT_LE (distance (colorOf (0, -5, 5), {255, 0, 88}), tolerance) << "up: blue";
}

TEST (FlowColors, LengthIsSaturation)
{
  EXPECT_EQ (colorOf (0, 0, 5), cv::Vec3b (255, 255, 255));
  EXPECT_LE (distance (colorOf (2.5F, 0, 5), {127, 127, 255}), 1);
  EXPECT_LE (distance (colorOf (9, 0, 5), {0, 0, 191}), 1) << "longer is darker";
}

TEST (FlowColors, UnknownIsBlack)
{
  EXPECT_EQ (colorOf (kNan, 1, 5), cv::Vec3b (0, 0, 0));
  EXPECT_EQ (colorOf (1, std::numeric_limits<float>::infinity(), 5),
             cv::Vec3b (0, 0, 0));
}

TEST (FlowColors, AutomaticMaximumPassesOutliersBy)
{
  cv::Mat flow (10, 100, CV_32FC2, cv::Scalar (2, 0));
  flow.at<cv::Vec2f> (0, 0) = {500, 0};
  flow.at<cv::Vec2f> (0, 1) = {kNan, 0};
  EXPECT_EQ (io::flowLength (flow, 1.0), 500.0);
  EXPECT_EQ (io::flowLength (flow, 0.99), 2.0);
  EXPECT_EQ (io::flowLength (cv::Mat (2, 2, CV_32FC2, cv::Scalar::all (kNan)), 1), 0.0);
  const cv::Mat colors = io::flowColors (flow);
  EXPECT_LE (distance (colors.at<cv::Vec3b> (5, 5), {0, 0, 255}), 1);
}

TEST (FlowColors, WheelIsWhiteInTheMiddleAndRedOnTheRight)
{
  const cv::Mat wheel = io::flowWheel (101);
  EXPECT_LE (distance (wheel.at<cv::Vec3b> (50, 50), {255, 255, 255}), 3);
  EXPECT_LE (distance (wheel.at<cv::Vec3b> (50, 100), {0, 0, 255}), 8);
  EXPECT_EQ (wheel.at<cv::Vec3b> (0, 0), cv::Vec3b (255, 255, 255));
}

TEST (Figures, WarpFetchesWhereTheFlowPoints)
{
  cv::Mat current (1, 4, CV_8UC1);
  for (int col = 0; col < 4; ++col)
    current.at<unsigned char> (0, col) = static_cast<unsigned char> (40 * col);
  cv::Mat flow (1, 4, CV_32FC2, cv::Scalar (0.5, 0));
  flow.at<cv::Vec2f> (0, 1) = {kNan, kNan};
  const cv::Mat warped = io::warpToReference (current, flow);
  EXPECT_EQ (warped.at<unsigned char> (0, 0), 20);
  EXPECT_EQ (warped.at<unsigned char> (0, 1), 0);
  EXPECT_EQ (warped.at<unsigned char> (0, 2), 100);
  EXPECT_EQ (warped.at<unsigned char> (0, 3), 120) << "border replicated";
  const cv::Mat residual = io::brightnessResidual (current, current, flow);
  EXPECT_FLOAT_EQ (residual.at<float> (0, 0), 20.0F);
  EXPECT_TRUE (std::isnan (residual.at<float> (0, 1)));
  EXPECT_FLOAT_EQ (residual.at<float> (0, 3), 0.0F);
}

TEST (Figures, DepthResidualComparesTheWarpedPoint)
{
  SceneFlow flow;
  flow.flow = cv::Mat (1, 3, CV_32FC2, cv::Scalar (1, 0));
  flow.points = cv::Mat (1, 3, CV_32FC3, cv::Scalar (0, 0, 2));
  flow.displacement = cv::Mat (1, 3, CV_32FC3, cv::Scalar (0, 0, 0.5));
  const cv::Mat depth = (cv::Mat_<float> (1, 3) << 9.0F, 2.25F, 0.0F);
  const cv::Mat residual = io::depthResidual (flow, depth);
  EXPECT_FLOAT_EQ (residual.at<float> (0, 0), 0.25F);
  EXPECT_TRUE (std::isnan (residual.at<float> (0, 1))) << "no depth there";
  EXPECT_TRUE (std::isnan (residual.at<float> (0, 2))) << "out of view";
}

TEST (Figures, TintsAreGreyWhereImagesAgree)
{
  const cv::Mat same (1, 1, CV_8UC1, cv::Scalar (90));
  const cv::Mat other (1, 1, CV_8UC1, cv::Scalar (200));
  EXPECT_EQ (io::tintedOverlay (same, same).at<cv::Vec3b> (0, 0),
             cv::Vec3b (90, 90, 90));
  const auto tint = io::tintedOverlay (same, other).at<cv::Vec3b> (0, 0);
  EXPECT_EQ (tint, cv::Vec3b (200, 145, 90));
}

TEST (Figures, SegmentsHaveTheirOwnColours)
{
  cv::Mat labels (9, 9, CV_32SC1, cv::Scalar (0));
  labels.colRange (3, 6).setTo (1);
  labels.colRange (6, 9).setTo (-1);
  const cv::Mat image (9, 9, CV_8UC3, cv::Scalar::all (77));
  const cv::Mat picture = io::segmentOverlay (image, labels);
  EXPECT_NE (picture.at<cv::Vec3b> (4, 1), picture.at<cv::Vec3b> (4, 4));
  EXPECT_EQ (picture.at<cv::Vec3b> (4, 7), cv::Vec3b (77, 77, 77)) << "no segment";
  EXPECT_LT (cv::norm (picture.at<cv::Vec3b> (4, 2)),
             cv::norm (picture.at<cv::Vec3b> (4, 1)))
      << "boundary";
  EXPECT_EQ (io::segmentOverlay (cv::Mat(), labels).size(), labels.size());
}

TEST (Figures, UndeterminedSegmentsAreBlackAmongMotions)
{
  SceneFlow flow;
  flow.labels = (cv::Mat_<int> (1, 6) << 0, 0, 1, 1, 2, 2);
  flow.segments.resize (3);
  for (int i = 0; i < 3; ++i) {
    flow.segments[i].group = i == 0 ? 1 : 0;
    flow.segments[i].status = MotionStatus::Determined;
  }
  flow.segments[2].status = MotionStatus::Undetermined;
  flow.groups = 2;
  flow.dominant_group = 1;
  const cv::Mat image (1, 6, CV_8UC1, cv::Scalar (100));
  const cv::Mat picture = io::motionOverlay (image, flow);
  const auto dominant = picture.at<cv::Vec3b> (0, 0);
  const auto other = picture.at<cv::Vec3b> (0, 2);
  EXPECT_EQ (dominant[0], dominant[2]) << "grey";
  EXPECT_FALSE (other[0] == other[1] && other[1] == other[2]) << "coloured";
  EXPECT_LT (picture.at<cv::Vec3b> (0, 5)[0], dominant[0]) << "black over the image";
}

TEST (Figures, VisibilityHasAColourForEveryKind)
{
  const cv::Mat kinds = (cv::Mat_<unsigned char> (1, 5) << 0, 64, 128, 192, 255);
  const cv::Mat image (1, 5, CV_8UC3, cv::Scalar::all (77));
  const cv::Mat picture = io::visibilityPicture (image, kinds);
  EXPECT_EQ (picture.at<cv::Vec3b> (0, 4), cv::Vec3b (77, 77, 77));
  for (int a = 0; a < 5; ++a)
    for (int b = 0; b < a; ++b)
      EXPECT_NE (picture.at<cv::Vec3b> (0, a), picture.at<cv::Vec3b> (0, b));
}

TEST (Figures, ScalarsKeepTheirPlaceAndUnknownIsBlack)
{
  cv::Mat scalar (20, 60, CV_32FC1, cv::Scalar (1));
  scalar.at<float> (3, 4) = kNan;
  scalar.colRange (30, 60).setTo (0.1F);
  const cv::Mat picture = io::scalarPicture (scalar, 1.0, "px");
  ASSERT_EQ (picture.cols, 60);
  ASSERT_GT (picture.rows, 20) << "scale bar";
  EXPECT_EQ (picture.at<cv::Vec3b> (3, 4), cv::Vec3b (0, 0, 0));
  EXPECT_GT (cv::norm (picture.at<cv::Vec3b> (3, 5)),
             cv::norm (picture.at<cv::Vec3b> (3, 40)));
  const cv::Mat none (20, 60, CV_32FC1, cv::Scalar (kNan));
  EXPECT_NO_THROW (io::scalarPicture (none, 0.0, "px"));
  EXPECT_NO_THROW (io::depthPicture (none));
  EXPECT_NO_THROW (io::scalarPicture (cv::Mat (1, 1, CV_32FC1, 0.0), 0.0, ""));
}

TEST (Figures, SheetHasRoomForAll)
{
  const cv::Mat wide (10, 40, CV_8UC3, cv::Scalar (255, 0, 0));
  const cv::Mat tall (80, 40, CV_8UC1, cv::Scalar (9));
  const cv::Mat sheet =
      io::contactSheet ({{"a", wide}, {"b", tall}, {"c", wide}}, 2, 80);
  EXPECT_GT (sheet.cols, 160);
  EXPECT_GT (sheet.rows, 320);
  cv::Mat blue;
  cv::inRange (sheet, cv::Scalar (255, 0, 0), cv::Scalar (255, 0, 0), blue);
  EXPECT_EQ (cv::countNonZero (blue), 2 * 80 * 20);
}

} // namespace
