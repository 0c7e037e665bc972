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

int
countColor (const cv::Mat& picture, const cv::Scalar& low, const cv::Scalar& high)
{
  cv::Mat found;
  cv::inRange (picture, low, high, found);
  return cv::countNonZero (found);
}

TEST (FlowFigures, PictureHasTheWheelInItsCorner)
{
  const cv::Mat flow (240, 320, CV_32FC2, cv::Scalar (4, 0));
  const cv::Mat picture = io::flowPicture (flow, 4.0);
  const cv::Mat colors = io::flowColors (flow, 4.0);
  EXPECT_EQ (picture.at<cv::Vec3b> (200, 300), colors.at<cv::Vec3b> (200, 300));
  const cv::Mat corner = picture (cv::Rect (0, 0, 40, 40));
  EXPECT_GT (countColor (corner, {150, 0, 0}, {255, 140, 160}), 20)
      << "blue of the wheel";
  const cv::Mat small (10, 10, CV_32FC2, cv::Scalar (4, 0));
  EXPECT_EQ (cv::norm (io::flowPicture (small, 4.0), io::flowColors (small, 4.0)), 0.0)
      << "no room";
}

TEST (FlowFigures, FlickerPairStandsStillWhereTheFlowIsRight)
{
  cv::Mat reference (4, 8, CV_8UC1);
  for (int col = 0; col < 8; ++col)
    reference.col (col).setTo (30 * col);
  cv::Mat current (4, 8, CV_8UC1, cv::Scalar (0)); // moved by two to the right
  reference.colRange (0, 6).copyTo (current.colRange (2, 8));
  cv::Mat flow (4, 8, CV_32FC2, cv::Scalar (2, 0));
  flow.at<cv::Vec2f> (1, 1) = {kNan, kNan};
  const io::FlickerPair pair = io::flickerPair (reference, current, flow);
  EXPECT_EQ (cv::norm (pair.before.colRange (0, 6), pair.after.colRange (0, 6)), 0.0);
  EXPECT_EQ (pair.before.at<cv::Vec3b> (1, 1), cv::Vec3b (0, 0, 0));
  EXPECT_EQ (pair.before.at<cv::Vec3b> (0, 3), cv::Vec3b (90, 90, 90));
}

/** Four segments in a row, 2 m away, linked strongly, loosely and not at all. */
SceneFlow
chain ()
{
  SceneFlow flow;
  flow.camera = {100.0, 100.0, 100.0, 50.0};
  flow.labels = cv::Mat (100, 200, CV_32SC1, cv::Scalar (0));
  flow.segments.resize (5);
  for (int i = 0; i < 4; ++i)
    flow.segments[i].centroid = {i - 1.5, 0.0, 2.0}; // pixels 25, 75, 125, 175
  flow.pairs = {{0, 1, 0.99}, {1, 2, 0.7}, {2, 3, 0.1}, {3, 4, 1.0}};
  return flow;
}

TEST (WeightsFigure, ConnectionsHaveTheColourOfTheirStrength)
{
  const cv::Mat picture =
      io::weightsPicture (cv::Mat (100, 200, CV_8UC1, cv::Scalar (50)), chain());
  ASSERT_EQ (picture.cols, 400) << "twice the size, so that lines have room";
  ASSERT_GT (picture.rows, 200) << "legend";
  const auto between = [&picture] (int col) {
    return picture.at<cv::Vec3b> (100, 2 * col);
  };
  const cv::Vec3b together = between (50);
  const cv::Vec3b loose = between (100);
  const cv::Vec3b broken = between (150);
  EXPECT_GT (together[1], together[2] + 50) << "green";
  EXPECT_GT (loose[1], 150);
  EXPECT_GT (loose[2], 150) << "yellow";
  EXPECT_GT (broken[2], broken[1] + 100) << "red";
  EXPECT_EQ (between (190), cv::Vec3b (30, 30, 30)) << "segment 4 has no place";
}

TEST (WeightsFigure, NothingToDrawIsFine)
{
  EXPECT_NO_THROW (io::weightsPicture (cv::Mat(), chain()));
  SceneFlow flow = chain();
  flow.pairs = {{0, 17, 1.0}, {-1, 2, 1.0}};
  flow.segments.clear();
  EXPECT_NO_THROW (io::weightsPicture (cv::Mat(), flow));
}

Report
someReport ()
{
  Report report;
  for (int level = 1; level >= 0; --level)
    for (int i = 0; i < 5; ++i) {
      IterationRecord record;
      record.level = level;
      record.terms = {0.5, 0.05, 0.005, 0.0};
      record.cost = record.terms.total();
      report.history.push_back (record);
    }
  return report;
}

TEST (ConvergencePlot, TermsAreDrawnAtTheirDecade)
{
  const cv::Mat plot = io::convergencePlot (someReport(), {640, 480});
  ASSERT_EQ (plot.size(), cv::Size (640, 480));
  EXPECT_GT (countColor (plot, {20, 110, 230}, {40, 130, 250}), 200) << "brightness";
  EXPECT_GT (countColor (plot, {190, 100, 10}, {210, 120, 30}), 200) << "icp";
  // Brightness lies above icp, a tenth of it.
  const auto meanRow = [&plot] (const cv::Scalar& low, const cv::Scalar& high) {
    cv::Mat found;
    cv::inRange (plot.rowRange (0, 400), low, high, found);
    double sum = 0.0;
    for (int row = 0; row < found.rows; ++row)
      sum += row * cv::countNonZero (found.row (row));
    return sum / std::max (1, cv::countNonZero (found));
  };
  EXPECT_LT (meanRow ({20, 110, 230}, {40, 130, 250}) + 30,
             meanRow ({190, 100, 10}, {210, 120, 30}));
  EXPECT_GT (countColor (plot, cv::Scalar::all (230), cv::Scalar::all (240)), 1000)
      << "the band of the odd level";
}

TEST (ConvergencePlot, NoLineLeadsToAnotherEnergy)
{
  Report report;
  for (int i = 0; i < 6; ++i) {
    IterationRecord record;
    record.energy = i / 3; // the second is in another unit
    record.terms.icp = record.cost = i < 3 ? 1.0 : 100.0;
    report.history.push_back (record);
  }
  const cv::Mat broken = io::convergencePlot (report, {640, 480});
  for (IterationRecord& record : report.history)
    record.energy = 0;
  const cv::Mat joined = io::convergencePlot (report, {640, 480});
  // Between the third and the fourth step, half-way between both costs.
  const cv::Rect middle (310, 180, 60, 40);
  const auto blacks = [&middle] (const cv::Mat& plot) {
    return countColor (plot (middle), cv::Scalar::all (0), cv::Scalar::all (40));
  };
  EXPECT_GT (blacks (joined), 20);
  EXPECT_EQ (blacks (broken), 0);
  const auto grays = [&middle] (const cv::Mat& plot) {
    return countColor (plot (middle), cv::Scalar::all (50), cv::Scalar::all (200));
  };
  EXPECT_GT (grays (broken), 10) << "dashes";
}

TEST (ConvergencePlot, WhatHasNoValueHasNoCurve)
{
  Report report = someReport(); // no prior, no concatenation
  const cv::Mat without = io::convergencePlot (report, {640, 480});
  const auto counts = [] (const cv::Mat& plot, const cv::Scalar& color) {
    return countColor (
        plot, color - cv::Scalar::all (12), color + cv::Scalar::all (12));
  };
  const cv::Scalar prior (170, 60, 160), concatenation (150, 150, 20);
  EXPECT_EQ (counts (without, prior), 0);
  EXPECT_EQ (counts (without, concatenation), 0);
  for (IterationRecord& record : report.history)
    record.terms.concatenation = 0.2;
  EXPECT_GT (counts (io::convergencePlot (report, {640, 480}), concatenation), 200);
}

TEST (ConvergencePlot, EmptyAndBrokenHistoriesHaveAPicture)
{
  EXPECT_EQ (io::convergencePlot (Report(), {160, 120}).size(), cv::Size (160, 120));
  Report report = someReport();
  report.history[3].cost = std::numeric_limits<double>::quiet_NaN();
  report.history[4].terms.icp = std::numeric_limits<double>::infinity();
  EXPECT_NO_THROW (io::convergencePlot (report, {320, 240}));
}

} // namespace
