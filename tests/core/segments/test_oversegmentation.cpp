// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/segments/connected_segments.h"
#include "core/segments/surface_clusters.h"
#include "support/analytic_scene.h"
#include "support/points.h"
#include <pcl_msf/oversegmentation.h>

#include <random>
#include <set>
#include <vector>

namespace {

using namespace pcl_msf;

/** The box stands half a metre before the wall, clear of the floor; the texture is one
 * and the same, so that only depth tells them apart. */
test::AnalyticScene
boxBeforeWall ()
{
  test::AnalyticScene s;
  s.quads.push_back ({{-4, -3, 2.5}, {8, 0, 0}, {0, 6, 0}, 0, 0.0});
  s.quads.push_back ({{-0.5, -0.4, 2.0}, {0.9, 0, 0.1}, {0, 0.8, 0}, 1, 0.0});
  s.motions.resize (2);
  return s;
}

/** Segments that hold points of more than one body. */
int
mixedSegments (const Oversegmentation& segments, const cv::Mat& body)
{
  std::vector<std::set<int>> bodies (segments.size());
  for (int y = 0; y < body.rows; ++y)
    for (int x = 0; x < body.cols; ++x)
      if (segments.labels().at<int> (y, x) >= 0)
        bodies[segments.labels().at<int> (y, x)].insert (body.at<int> (y, x));
  int mixed = 0;
  for (const auto& b : bodies)
    mixed += b.size() > 1 ? 1 : 0;
  return mixed;
}

std::vector<int>
sizesOf (const Oversegmentation& segments)
{
  std::vector<int> sizes (segments.size(), 0);
  for (const int label : cv::Mat_<int> (segments.labels()))
    if (label >= 0)
      ++sizes[label];
  return sizes;
}

bool
same (const cv::Mat& a, const cv::Mat& b)
{
  return a.size() == b.size() && cv::countNonZero (a != b) == 0;
}

class EveryMethod : public testing::TestWithParam<SegmentationMethod> {
protected:
  static SegmentationParameters
  parameters ()
  {
    SegmentationParameters p;
    p.method = GetParam();
    p.min_points = 200;
    return p;
  }
};

TEST_P (EveryMethod, LabelsAreDenseAndCoverWhatHasDepth)
{
  const test::AnalyticScene scene = boxBeforeWall();
  test::View view = scene.render (false);
  view.depth (cv::Rect (100, 20, 13, 9)) = std::nanf ("");
  const RgbdFrame frame = scene.frame (view);
  const Oversegmentation segments = Oversegmentation::fromFrame (frame, parameters());
  ASSERT_EQ (segments.labels().type(), CV_32SC1);
  ASSERT_EQ (segments.labels().size(), view.depth.size());
  for (const int size : sizesOf (segments))
    EXPECT_GT (size, 0);
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      const int label = segments.labels().at<int> (y, x);
      EXPECT_LT (label, segments.size());
      EXPECT_EQ (label >= 0, frame.levels()[0].inverse_depth.at<float> (y, x) > 0.0f);
    }
}

TEST_P (EveryMethod, SameFrameSameLabels)
{
  const test::AnalyticScene scene = test::roomWithBox();
  const test::View view = scene.render (false);
  const auto cut = [&] {
    return Oversegmentation::fromFrame (scene.frame (view), parameters()).labels();
  };
  const cv::Mat first = cut();
  EXPECT_TRUE (same (first, cut()));
  EXPECT_TRUE (same (first, cut()));
}

TEST_P (EveryMethod, WorksWithoutColour)
{
  const test::AnalyticScene scene = boxBeforeWall();
  test::View view = scene.render (false);
  view.color = cv::Mat();
  EXPECT_GT (Oversegmentation::fromFrame (scene.frame (view), parameters()).size(), 0);
}

INSTANTIATE_TEST_SUITE_P (Methods,
                          EveryMethod,
                          testing::Values (SegmentationMethod::TangentPlane,
                                           SegmentationMethod::Tiles,
                                           SegmentationMethod::Single));
#if PCL_MSF_HAS_XIMGPROC
INSTANTIATE_TEST_SUITE_P (LibraryMethods,
                          EveryMethod,
                          testing::Values (SegmentationMethod::Felzenszwalb,
                                           SegmentationMethod::Slic));
#endif

/** The methods that ask OpenCV's ximgproc, where it is there, and one more. */
std::vector<SegmentationMethod>
libraryMethodAnd (SegmentationMethod library, SegmentationMethod other)
{
  if (PCL_MSF_HAS_XIMGPROC)
    return {other, library};
  return {other};
}

TEST (Oversegmentation, DepthEdgesAreRespected)
{
  const test::AnalyticScene scene = boxBeforeWall();
  const test::View view = scene.render (false);
  for (const auto method : libraryMethodAnd (SegmentationMethod::Felzenszwalb,
                                             SegmentationMethod::TangentPlane)) {
    SegmentationParameters p;
    p.method = method;
    p.min_points = 200;
    p.threshold = 0.2;
    const auto segments = Oversegmentation::fromFrame (scene.frame (view), p);
    EXPECT_GE (segments.size(), 2);
    EXPECT_EQ (mixedSegments (segments, view.body), 0) << static_cast<int> (method);
  }
  SegmentationParameters tiles;
  tiles.method = SegmentationMethod::Tiles; // what the above is there to avoid
  const auto segments = Oversegmentation::fromFrame (scene.frame (view), tiles);
  EXPECT_GT (mixedSegments (segments, view.body), 0);
}

TEST (Oversegmentation, NoisyDepthEdgesAreRespected)
{
  const test::AnalyticScene scene = boxBeforeWall();
  test::View view = scene.render (false);
  std::mt19937 generator (2);
  std::normal_distribution<float> normal (0.0f, 0.0025f); // a Kinect's, 1 / metres
  for (float& z : cv::Mat_<float> (view.depth))
    z = 1.0f / (1.0f / z + normal (generator));
  const auto segments = Oversegmentation::fromFrame (scene.frame (view));
  EXPECT_EQ (mixedSegments (segments, view.body), 0);
}

TEST (ConnectedSegments, OneLabelIsSplitAtDepthEdges)
{
  const test::AnalyticScene scene = boxBeforeWall();
  const test::View view = scene.render (false);
  const RgbdFrame frame = scene.frame (view);
  const cv::Mat one (scene.height, scene.width, CV_32SC1, cv::Scalar (0));
  const auto split = Oversegmentation::fromLabels (
      connectSegments (one, frame.levels()[0], frame.inverseDepthNoise(), 50, {}, 2),
      frame);
  EXPECT_EQ (split.size(), 2);
  EXPECT_EQ (mixedSegments (split, view.body), 0);
}

TEST (Oversegmentation, RecedingFloorIsNotCutIntoStrips)
{
  test::AnalyticScene scene; // a Kinect at half resolution, 1.2 m above the floor
  scene.camera = {262.0, 262.0, 159.5, 119.5};
  scene.width = 320;
  scene.height = 240;
  scene.quads = {{{-20, 1.2, 0.5}, {40, 0, 0}, {0, 0, 7.5}, 0, 0.0}};
  scene.motions.resize (1);
  test::View view = scene.render (false);
  view.color = cv::Mat();
  const RgbdFrame frame = scene.frame (view);
  const auto segments = Oversegmentation::fromFrame (frame);
  std::vector<cv::Rect> boxes (segments.size());
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x)
      if (segments.labels().at<int> (y, x) >= 0)
        boxes[segments.labels().at<int> (y, x)] |= cv::Rect (x, y, 1, 1);
  const std::vector<int> sizes = sizesOf (segments);
  int thin = 0;
  for (int k = 0; k < segments.size(); ++k) {
    // A strip is far longer than high.
    const bool strip = boxes[k].width > 3 * boxes[k].height;
    thin += strip ? sizes[k] : 0;
  }
  EXPECT_LT (thin, 0.05 * cv::countNonZero (frame.levels()[0].inverse_depth));
}

TEST (Oversegmentation, SegmentsHaveTheAimedSize)
{
  const test::AnalyticScene scene = test::roomWithBox();
  auto methods =
      libraryMethodAnd (SegmentationMethod::Slic, SegmentationMethod::TangentPlane);
  methods.push_back (SegmentationMethod::Tiles);
  for (const auto method : methods)
    for (const int side : {12, 24}) {
      SegmentationParameters p;
      p.method = method;
      p.segment_size = side;
      const auto segments =
          Oversegmentation::fromFrame (scene.frame (scene.render (false)), p);
      for (const int size : sizesOf (segments))
        EXPECT_LE (size, 4 * side * side) << static_cast<int> (method);
      const int aimed = scene.width * scene.height / (side * side);
      EXPECT_GT (segments.size(), aimed / 2);
      EXPECT_LT (segments.size(), 3 * aimed);
    }
}

TEST (Oversegmentation, FelzenszwalbMergesOrDiscardsSmallSegments)
{
  if (!PCL_MSF_HAS_XIMGPROC)
    GTEST_SKIP() << "built without OpenCV's ximgproc";
  test::AnalyticScene scene = boxBeforeWall();
  scene.quads.push_back ({{0.3, 0.25, 1.0}, {0.1, 0, 0}, {0, 0.1, 0}, 2, 0.0});
  scene.motions.resize (3);
  const test::View view = scene.render (false);
  const RgbdFrame frame = scene.frame (view);
  const int small = cv::countNonZero (view.body == 2);
  ASSERT_GT (small, 100);
  SegmentationParameters p;
  p.method = SegmentationMethod::Felzenszwalb;
  p.threshold = 0.2;
  p.min_points = 2 * small;
  const auto merged = Oversegmentation::fromFrame (frame, p);
  EXPECT_EQ (cv::countNonZero (merged.labels() < 0), 0);
  for (const int size : sizesOf (merged))
    EXPECT_GE (size, p.min_points);
  p.discard_small = true;
  const auto discarded = Oversegmentation::fromFrame (frame, p);
  EXPECT_EQ (cv::countNonZero ((discarded.labels() >= 0) & (view.body == 2)), 0);
  EXPECT_GT (cv::countNonZero (discarded.labels() >= 0), 0.8 * view.body.total());
  for (const int size : sizesOf (discarded))
    EXPECT_GE (size, p.min_points);
}

TEST (SurfaceClusters, AllInstructionSetsGiveTheSameLabels)
{
  const test::AnalyticScene scene = boxBeforeWall();
  const RgbdFrame frame = scene.frame (scene.render (false));
  for (const int size : {7, 24}) {
    const auto by = [&] (InstructionSet set) {
      return clusterSurfaces (frame.levels()[0], 1e-3, size, {}, 1, set);
    };
    const cv::Mat plain = by (InstructionSet::Default);
    double most = 0.0;
    cv::minMaxLoc (plain, nullptr, &most);
    EXPECT_GT (most, 20.0);
    for (const InstructionSet set : usableInstructionSets())
      EXPECT_EQ (cv::norm (by (set), plain, cv::NORM_INF), 0.0) << nameOf (set);
  }
}

} // namespace
