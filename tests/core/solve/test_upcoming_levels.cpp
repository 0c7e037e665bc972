// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/segments/segment_pixels.h"
#include "core/solve/upcoming_levels.h"
#include "support/analytic_scene.h"
#include "support/window_scene.h"

#include <vector>

namespace {

using namespace pcl_msf;

/** Two frames of a wall and a box, three levels, one pair. */
class TwoLevels : public testing::TestWithParam<int> {
protected:
  TwoLevels() : pairs_ (2, 0), scene_{frames_, pairs_, 2, GetParam()}
  {
    test::AnalyticScene wall;
    wall.quads.push_back ({{-4, -3, 2.5}, {8, 0, 0}, {0, 6, 0}, 0, 0.9});
    wall.quads.push_back ({{-0.5, -0.4, 2.0}, {0.9, 0, 0.1}, {0, 0.8, 0}, 1, 0.9});
    wall.motions.resize (2);
    const test::View view = wall.render (false);
    frames_ = {wall.frame (view), wall.frame (view)};
    labels_ = view.body;
    scene_.used = {0};
  }
  UpcomingLevels::Request
  request (int level) const
  {
    cv::Mat labels = labels_;
    for (int i = 0; i < level; ++i)
      labels = halveLabels (labels);
    return {{labels, cv::Mat()}, pointOptions (scene_, level)};
  }
  void
  expectAsPrepared (const LevelPoints& points, int level) const
  {
    const UpcomingLevels::Request own = request (level);
    const LevelPoints wanted = prepareLevel (scene_, level, own.labels, own.options);
    ASSERT_GT (wanted.pixels[0].x.size(), 500U);
    EXPECT_EQ (points.pixels[0].pixel, wanted.pixels[0].pixel);
    EXPECT_EQ (points.pixels[0].x, wanted.pixels[0].x);
    EXPECT_EQ (points.probes.pixel, wanted.probes.pixel);
  }

  std::vector<RgbdFrame> frames_;
  FramePairs pairs_;
  WindowScene scene_;
  cv::Mat labels_;
};

TEST_P (TwoLevels, AreThoseThatThisThreadWouldMakeInAnyOrder)
{
  for (const std::vector<int>& order : {std::vector<int>{1, 0}, {0, 1}}) {
    UpcomingLevels levels;
    EXPECT_FALSE (levels.has (1));
    levels.begin (scene_, {request (1), request (0)});
    EXPECT_TRUE (levels.has (0) && levels.has (1));
    for (const int level : order) {
      expectAsPrepared (levels.take (level), level);
      EXPECT_FALSE (levels.has (level)) << "it is given away";
    }
  }
}

TEST_P (TwoLevels, NeedNotBeTaken)
{
  UpcomingLevels levels;
  levels.begin (scene_, {request (1), request (0)});
}

INSTANTIATE_TEST_SUITE_P (Threads, TwoLevels, testing::Values (1, 2, 5));

} // namespace
