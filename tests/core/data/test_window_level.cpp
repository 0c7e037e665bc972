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

} // namespace
