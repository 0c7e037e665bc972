// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <pcl_msf/errors.h>
#include <pcl_msf/oversegmentation.h>

#include <cmath>
#include <functional>
#include <limits>

namespace {

using namespace pcl_msf;
using testing::HasSubstr;

bool
same (const cv::Mat& a, const cv::Mat& b)
{
  return a.size() == b.size() && cv::countNonZero (a != b) == 0;
}

/** A frame of 48 x 40 at 2 m without depth in its first row. */
RgbdFrame
plainFrame ()
{
  cv::Mat depth (40, 48, CV_32FC1, cv::Scalar (2));
  depth.row (0) = 0.0f;
  return RgbdFrame::fromImages ({}, depth, {50, 50, 24, 20});
}

TEST (FromLabels, NegativeGapsAndDepthlessOnesAreSortedOut)
{
  cv::Mat labels (40, 48, CV_32SC1, cv::Scalar (-7));
  labels.row (0) = 1; // no depth: must vanish
  labels.row (3) = 1000000;
  labels.row (5) = 3;
  labels.row (9) = std::numeric_limits<int>::max();
  const cv::Mat before = labels.clone();
  const auto segments = Oversegmentation::fromLabels (labels, plainFrame());
  EXPECT_EQ (segments.size(), 3);
  EXPECT_EQ (segments.labels().at<int> (0, 4), -1);
  EXPECT_EQ (segments.labels().at<int> (1, 4), -1);
  EXPECT_EQ (segments.labels().at<int> (3, 4), 1);
  EXPECT_EQ (segments.labels().at<int> (5, 4), 0);
  EXPECT_EQ (segments.labels().at<int> (9, 4), 2);
  EXPECT_TRUE (same (labels, before)); // the caller's image stays as it was
}

TEST (FromIndices, FirstClusterWinsAndEmptyOnesVanish)
{
  std::vector<pcl::PointIndices> clusters (4);
  clusters[0].indices = {5 * 48 + 1, 5 * 48 + 2};
  clusters[2].indices = {5 * 48 + 2, 7 * 48 + 47};
  clusters[3].indices = {3}; // has no depth
  const auto segments = Oversegmentation::fromIndices (clusters, plainFrame());
  EXPECT_EQ (segments.size(), 2);
  EXPECT_EQ (segments.labels().at<int> (5, 1), 0);
  EXPECT_EQ (segments.labels().at<int> (5, 2), 0);
  EXPECT_EQ (segments.labels().at<int> (7, 47), 1);
  EXPECT_EQ (cv::countNonZero (segments.labels() >= 0), 3);
}

void
expectRefused (const std::function<void()>& call, const char* remedy)
{
  try {
    call();
    ADD_FAILURE() << "accepted: " << remedy;
  }
  catch (const InvalidInput& error) {
    EXPECT_THAT (error.what(), HasSubstr (remedy));
  }
}

TEST (Oversegmentation, RefusesBadInputAndSaysWhy)
{
  const RgbdFrame frame = plainFrame();
  const cv::Mat labels (40, 48, CV_32SC1, cv::Scalar (0));
  const auto take = [&] (const cv::Mat& l) { Oversegmentation::fromLabels (l, frame); };
  expectRefused ([&] { take ({}); }, "of the frame's size");
  expectRefused ([&] { take (labels.rowRange (0, 39)); }, "of the frame's size");
  expectRefused ([&] { take (cv::Mat (40, 48, CV_8UC1)); }, "CV_32SC1");
  expectRefused ([&] { take (labels - 1); }, "no segment has a point with depth");
  expectRefused ([&] { Oversegmentation::fromLabels (labels, {}); }, "frame is empty");
  for (const int index : {-1, 40 * 48}) {
    std::vector<pcl::PointIndices> clusters (1);
    clusters[0].indices = {48 * 5, index};
    expectRefused ([&] { Oversegmentation::fromIndices (clusters, frame); },
                   "the cloud only 48x40 points");
  }
  expectRefused ([&] { Oversegmentation::fromIndices ({}, frame); }, "no segment");
  expectRefused ([&] { Oversegmentation::fromIndices ({}, {}); }, "empty");
  expectRefused ([&] { Oversegmentation::fromFrame ({}); }, "frame is empty");
}

TEST (Oversegmentation, RefusesBadParametersAndNamesTheirRange)
{
  const RgbdFrame frame = plainFrame();
  std::vector<std::pair<SegmentationParameters, const char*>> bad (5);
  bad[0] = {{}, "threshold must be"};
  bad[0].first.threshold = 0.0;
  bad[1] = {{}, "threshold must be"};
  bad[1].first.threshold = std::nan ("");
  bad[2] = {{}, "min_points must be"};
  bad[2].first.min_points = 0;
  bad[3] = {{}, "segment_size must be in"};
  bad[3].first.segment_size = 3;
  bad[4] = {{}, "segment_size must be in"};
  bad[4].first.segment_size = 513;
  for (const auto& [parameters, remedy] : bad)
    expectRefused ([&, p = parameters] { Oversegmentation::fromFrame (frame, p); },
                   remedy);
}

/** The same frame, halved before anything else: 24 x 20. */
RgbdFrame
halfFrame ()
{
  FrameParameters half;
  half.finest_level = 1;
  return RgbdFrame::fromImages (
      {}, cv::Mat (40, 48, CV_32FC1, cv::Scalar (2)), {50, 50, 24, 20}, half);
}

TEST (FromLabels, AreHalvedWithTheFrameOrAreOfItsSize)
{
  cv::Mat labels (40, 48, CV_32SC1, cv::Scalar (4));
  labels.colRange (24, 48) = 9;
  const auto of_input = Oversegmentation::fromLabels (labels, halfFrame());
  ASSERT_EQ (of_input.labels().size(), cv::Size (24, 20));
  EXPECT_EQ (of_input.labels().at<int> (3, 11), 0);
  EXPECT_EQ (of_input.labels().at<int> (3, 12), 1);
  const cv::Mat own = of_input.labels();
  EXPECT_TRUE (same (Oversegmentation::fromLabels (own, halfFrame()).labels(), own));
  EXPECT_THROW (Oversegmentation::fromLabels (own, plainFrame()), InvalidInput);
}

TEST (FromIndices, AreOfTheInputsPixels)
{
  std::vector<pcl::PointIndices> clusters (1);
  clusters[0].indices = {6 * 48 + 10, 39 * 48 + 47};
  const auto segments = Oversegmentation::fromIndices (clusters, halfFrame());
  EXPECT_EQ (segments.labels().at<int> (3, 5), 0);
  EXPECT_EQ (segments.labels().at<int> (19, 23), 0);
  EXPECT_EQ (cv::countNonZero (segments.labels() >= 0), 2);
}

} // namespace
