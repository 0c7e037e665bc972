// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <pcl_msf/errors.h>
#include <pcl_msf/evaluation/flow_errors.h>

#include <cmath>
#include <limits>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::evaluation;

const float kNan = std::numeric_limits<float>::quiet_NaN();

cv::Mat
row (const std::vector<cv::Vec2f>& values)
{
  return cv::Mat (values, true).reshape (2, 1);
}

cv::Mat
row3 (const std::vector<cv::Vec3f>& values)
{
  return cv::Mat (values, true).reshape (3, 1);
}

cv::Mat
bytes (const std::vector<unsigned char>& values)
{
  return cv::Mat (values, true).reshape (1, 1);
}

cv::Mat
allOf (const cv::Mat& image)
{
  return {image.size(), CV_8UC1, cv::Scalar (255)};
}

TEST (FlowErrors, EndPointErrorsByHand)
{
  // Errors 5, 0, 1 pixels.
  const cv::Mat truth = row ({{0, 0}, {2, 1}, {-1, 0}});
  const cv::Mat flow = row ({{3, 4}, {2, 1}, {-1, 1}});
  const FlowErrors e = flowErrors (flow, truth, allOf (truth));
  EXPECT_EQ (e.points, 3);
  EXPECT_DOUBLE_EQ (e.epe, 2.0);
  EXPECT_DOUBLE_EQ (e.median, 1.0);
  EXPECT_DOUBLE_EQ (e.rms, std::sqrt (26.0 / 3.0));
  EXPECT_DOUBLE_EQ (e.coverage, 1.0);
}

TEST (FlowErrors, ErrorsOfPixelsAreThoseOfTheMean)
{
  const cv::Mat truth = row ({{0, 0}, {3, 4}, {kNan, 0}});
  const cv::Mat flow = row ({{3, 4}, {kNan, kNan}, {1, 1}});
  const cv::Mat errors = endPointErrors (flow, truth);
  EXPECT_EQ (errors.at<float> (0, 0), 5.0F);
  EXPECT_EQ (errors.at<float> (0, 1), 5.0F) << "an unknown flow is no motion";
  EXPECT_TRUE (std::isnan (errors.at<float> (0, 2)));
  EXPECT_DOUBLE_EQ (flowErrors (flow, truth, allOf (truth)).epe, 5.0);
}

TEST (FlowErrors, AngularErrorOfBarronByHand)
{
  // (1, 0, 1) and (0, 0, 1) include 45 deg, (1, 0, 1) and (0, 1, 1) 60 deg.
  const cv::Mat truth = row ({{0, 0}, {0, 1}});
  const cv::Mat flow = row ({{1, 0}, {1, 0}});
  EXPECT_NEAR (flowErrors (flow, truth, allOf (truth)).angle, 52.5, 1e-12);
  EXPECT_DOUBLE_EQ (flowErrors (truth, truth, allOf (truth)).angle, 0.0);
}

TEST (FlowErrors, SmallAnglesAreNotRoundedAway)
{
  const cv::Mat truth = row ({{0, 0}});
  const cv::Mat flow = row ({{1e-6f, 0}});
  EXPECT_NEAR (flowErrors (flow, truth, allOf (truth)).angle, 1e-6 * 180 / M_PI, 1e-11);
}

TEST (FlowErrors, OutliersExceedThreePixelsAndFivePercent)
{
  // 3.5 px of 0: yes; 3.5 px of 100: below 5 %; 6 px of 100: yes; 2 px of 1: no.
  const cv::Mat truth = row ({{0, 0}, {100, 0}, {100, 0}, {1, 0}});
  const cv::Mat flow = row ({{3.5f, 0}, {103.5f, 0}, {106, 0}, {3, 0}});
  EXPECT_DOUBLE_EQ (flowErrors (flow, truth, allOf (truth)).outliers, 0.5);
}

TEST (FlowErrors, UnknownEstimatesCountAsZeroMotion)
{
  const cv::Mat truth = row ({{3, 4}, {1, 0}});
  const cv::Mat flow = row ({{kNan, kNan}, {1, 0}});
  const FlowErrors e = flowErrors (flow, truth, allOf (truth));
  EXPECT_DOUBLE_EQ (e.epe, 2.5);
  EXPECT_DOUBLE_EQ (e.coverage, 0.5);
}

TEST (FlowErrors, UnknownTruthAndMaskedPointsDoNotCount)
{
  const cv::Mat truth = row ({{kNan, 0}, {0, 0}, {0, 0}});
  const cv::Mat flow = row ({{9, 9}, {9, 9}, {0, 2}});
  const FlowErrors e = flowErrors (flow, truth, bytes ({255, 0, 255}));
  EXPECT_EQ (e.points, 1);
  EXPECT_DOUBLE_EQ (e.epe, 2.0);
}

TEST (FlowErrors, NothingToScoreIsNotZeroError)
{
  const cv::Mat truth = row ({{0, 0}});
  const FlowErrors e = flowErrors (truth, truth, bytes ({0}));
  EXPECT_EQ (e.points, 0);
  EXPECT_TRUE (std::isnan (e.epe));
  EXPECT_TRUE (std::isnan (e.outliers));
}

TEST (FlowErrors, OtherSizesAndTypesAreRefused)
{
  const cv::Mat truth = row ({{0, 0}});
  EXPECT_THROW (flowErrors (row ({{0, 0}, {0, 0}}), truth, allOf (truth)),
                InvalidInput);
  EXPECT_THROW (flowErrors (row3 ({{0, 0, 0}}), truth, allOf (truth)), InvalidInput);
  EXPECT_THROW (flowErrors (truth, truth, bytes ({255, 255})), InvalidInput);
}

TEST (SceneFlowErrors, DistancesAndSharesByHand)
{
  // Errors 0.005, 0.03, 0.5 (unknown: zero motion), 0 metres.
  const cv::Mat truth = row3 ({{0, 0, 0}, {0, 0, 1}, {0.3f, 0.4f, 0}, {1, 1, 1}});
  const cv::Mat motion =
      row3 ({{0, 0.005f, 0}, {0, 0.03f, 1}, {kNan, kNan, kNan}, {1, 1, 1}});
  const SceneFlowErrors e = sceneFlowErrors (motion, truth, allOf (truth));
  EXPECT_EQ (e.points, 4);
  EXPECT_NEAR (e.epe, 0.535 / 4, 1e-7);
  EXPECT_NEAR (e.median, 0.0175, 1e-7);
  EXPECT_NEAR (e.rms, std::sqrt ((2.5e-5 + 9e-4 + 0.25) / 4), 1e-7);
  EXPECT_DOUBLE_EQ (e.under_5cm, 0.75);
  EXPECT_DOUBLE_EQ (e.under_1cm, 0.5);
  EXPECT_DOUBLE_EQ (e.coverage, 0.75);
}

TEST (ScoredPoints, SplitsPointsWithDepthByVisibility)
{
  const cv::Mat depth = (cv::Mat_<float> (1, 4) << 1.0f, 2.0f, 0.0f, kNan);
  const cv::Mat visible = bytes ({255, 0, 255, 0});
  const auto mask = [&] (const cv::Mat& v, ScoredPoints set) {
    const cv::Mat m = scoredPoints (depth, v, set);
    return std::vector<int> (m.begin<unsigned char>(), m.end<unsigned char>());
  };
  using V = std::vector<int>;
  EXPECT_EQ (mask (visible, ScoredPoints::All), (V{255, 255, 0, 0}));
  EXPECT_EQ (mask (visible, ScoredPoints::Visible), (V{255, 0, 0, 0}));
  EXPECT_EQ (mask (visible, ScoredPoints::Occluded), (V{0, 255, 0, 0}));
  EXPECT_EQ (mask ({}, ScoredPoints::Visible), (V{255, 255, 0, 0}));
  EXPECT_EQ (mask ({}, ScoredPoints::Occluded), (V{0, 0, 0, 0}));
}

TEST (Averages, MeanAndMedian)
{
  EXPECT_DOUBLE_EQ (mean ({1, 2, 6}), 3.0);
  EXPECT_DOUBLE_EQ (median ({6, 1, 2}), 2.0);
  EXPECT_DOUBLE_EQ (median ({6, 1, 2, 4}), 3.0);
  EXPECT_TRUE (std::isnan (mean ({})));
  EXPECT_TRUE (std::isnan (median ({})));
}

TEST (SparsificationError, TellsGoodOrderFromBad)
{
  cv::Mat errors (10, 10, CV_32FC1), backwards (10, 10, CV_32FC1);
  for (int i = 0; i < 100; ++i) {
    errors.ptr<float>()[i] = static_cast<float> ((37 * i) % 100 + 1);
    backwards.ptr<float>()[i] = -errors.ptr<float>()[i];
  }
  const cv::Mat mask (10, 10, CV_8UC1, cv::Scalar (255));
  EXPECT_NEAR (sparsificationError (errors, 0.1 * errors, mask), 0.0, 1e-12);
  // Errors 1 .. 100: the curve of the order falls to 0, the other one rises to 2.
  EXPECT_NEAR (sparsificationError (errors, backwards, mask), 1.0, 0.05);
  cv::Mat unsure = backwards.clone();
  unsure.at<float> (0, 0) = std::nanf (""); // as the first that is taken away
  const cv::Mat constant (10, 10, CV_32FC1, cv::Scalar (1));
  const double none = sparsificationError (errors, constant, mask);
  EXPECT_GT (none, 0.3);
  EXPECT_LT (none, 0.7);
  EXPECT_TRUE (std::isfinite (sparsificationError (errors, unsure, mask)));
  EXPECT_TRUE (std::isnan (sparsificationError (errors, errors, 0 * mask)));
}

} // namespace
