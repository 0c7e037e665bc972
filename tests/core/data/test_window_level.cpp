// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/data/window_level.h"
#include "support/window_scene.h"

#include <numeric>

namespace {

using namespace pcl_msf;

class BrightnessOfALevel : public ::testing::Test {
protected:
  /** Mean intensity of the reference's points; that of all contrasts is about 0. */
  double
  mean () const
  {
    const std::vector<cv::Mat>& labels = window_.labels;
    const LevelPoints points =
        prepareLevel (window_.window, 0, labels, pointOptions (window_.window, 0));
    const SegmentPixels& reference = points.pixels[0];
    const auto begin = reference.intensity.begin();
    return std::accumulate (begin, begin + reference.begin.back(), 0.0) /
           reference.begin.back();
  }

  test::EnergyWindow window_{test::roomWithBox(), 3, 0};
};

TEST_F (BrightnessOfALevel, IsComparedAsItIsWhereItErrsIndependently)
{
  EXPECT_GT (mean(), 0.2);
}

TEST_F (BrightnessOfALevel, CountsLessTheFartherItErrsAlike)
{
  const double all = mean();
  // A quarter of the means' worth: 1 + (A - 1) 81 / 256 = 16, for 9 x 9 pixels in 16
  // x 16.
  window_.window.brightness_area = 1.0 + 15.0 * 256.0 / 81.0;
  EXPECT_NEAR (mean(), 0.25 * all, 0.01);
  window_.window.change.local = true;
  EXPECT_NEAR (mean(), 0.0, 0.01);
}

class ThinnedLevel : public ::testing::Test {
protected:
  ThinnedLevel()
  {
    window_.window.tuning.data.finest_thinning = 4;
    const PointOptions options = pointOptions (window_.window, 0);
    level_ = std::make_unique<WindowLevel> (
        window_.window,
        0,
        prepareLevel (window_.window, 0, window_.labels, options, true),
        EnergyParameters());
  }

  test::EnergyWindow window_{test::roomWithBox(), 3, 0};
  std::unique_ptr<WindowLevel> level_;
};

TEST_F (ThinnedLevel, KeepsAllPointsOfTheReference)
{
  const SegmentPixels& solved = level_->pixels (0);
  const SegmentPixels& whole = level_->wholeReference();
  for (int k = 0; k < whole.segments(); ++k) {
    EXPECT_GT (whole.size (k), 3 * solved.size (k));
    EXPECT_EQ (whole.pixels (k), whole.size (k));
    EXPECT_NEAR (solved.pixels (k), whole.pixels (k), 0.05 * whole.pixels (k));
  }
  const PointOptions options = pointOptions (window_.window, 0);
  const WindowLevel without (
      window_.window,
      0,
      prepareLevel (window_.window, 0, window_.labels, options, false),
      EnergyParameters());
  EXPECT_EQ (&without.wholeReference(), &without.pixels (0));
}

TEST_F (ThinnedLevel, SumsAreAboutThoseOfAllPoints)
{
  window_.window.tuning.data.finest_thinning = 1;
  WindowLevel all (window_.window, 0, window_.labels, EnergyParameters());
  for (WindowLevel* level : {level_.get(), &all})
    level->sweep (window_.state, DataTerm::Pass::Linearize);
  for (const int p : all.used())
    for (int k = 0; k < 2; ++k) {
      const SegmentQuadratic& some = level_->data (p).of (k);
      const SegmentQuadratic& whole = all.data (p).of (k);
      EXPECT_LT ((some.information - whole.information).norm(),
                 0.1 * whole.information.norm());
      EXPECT_NEAR (level_->data (p).totalWeight (k),
                   all.data (p).totalWeight (k),
                   0.05 * all.data (p).totalWeight (k));
    }
}

} // namespace
