// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/data/window_level.h"
#include "support/analytic_scene.h"
#include "support/window_scene.h"

#include <algorithm>
#include <cmath>
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
        prepareLevel (window_.window, 0, window_.labels, options, {true}),
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
  const WindowLevel without (window_.window,
                             0,
                             prepareLevel (window_.window, 0, window_.labels, options),
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

/** A pair of one view, the second with another exposure; level 0 prepared with means.
 */
class ExposedPair : public ::testing::Test {
protected:
  ExposedPair() : pairs_ (2, 0), scene_{frames_, pairs_, 1, 2}
  {
    test::AnalyticScene wall;
    wall.quads.push_back ({{-4, -3, 2.5}, {8, 0, 0}, {0, 6, 0}, 0, 0.9});
    wall.motions.resize (2);
    test::View view = wall.render (false);
    frames_.push_back (wall.frame (view));
    view.color = kGain * view.color + kOffset;
    frames_.push_back (wall.frame (view));
    scene_.used = {0};
    scene_.change = {kGain, kOffset};
    labels_ = {view.body, cv::Mat()};
  }
  LevelPoints
  prepared () const
  {
    return prepareLevel (
        scene_, 0, labels_, pointOptions (scene_, 0), {false, /*means*/ true});
  }
  /** Largest difference of a point's intensity from that of its pixel in the other
   * frame. */
  double
  largestMisfit (const LevelPoints& points) const
  {
    const kernel::Image image = points.textures[1]->image();
    const SegmentPixels& reference = points.pixels[0];
    double largest = 0.0;
    for (std::size_t i = 0; i < reference.pixel.size(); ++i)
      largest = std::max<double> (
          largest,
          std::abs (reference.intensity[i] - image.texels[2 * reference.pixel[i]]));
    return largest;
  }

  static constexpr float kGain = 0.8f;
  static constexpr float kOffset = 0.05f;
  std::vector<RgbdFrame> frames_;
  FramePairs pairs_;
  WindowScene scene_;
  std::vector<cv::Mat> labels_;
};

TEST_F (ExposedPair, FitsWhateverItsMeansCount)
{
  for (const double area : {1.0, 5.0, 100.0}) {
    scene_.brightness_area = 1.0;
    LevelPoints points = prepared();
    const std::vector<float> before = points.pixels[0].intensity;
    scene_.brightness_area = area;
    leaveMeansOut (scene_, 0, points);
    EXPECT_LT (largestMisfit (points), 1e-4) << area;
    EXPECT_EQ (points.pixels[0].intensity == before, area == 1.0) << area;
  }
}

TEST_F (ExposedPair, KeepsOfItsMeansWhatTheyCount)
{
  LevelPoints points = prepared();
  const std::vector<float> before = points.pixels[0].intensity;
  const std::vector<float> probes = points.probes.intensity;
  // A quarter of the means' worth, as above.
  scene_.brightness_area = 1.0 + 15.0 * 256.0 / 81.0;
  leaveMeansOut (scene_, 0, points);
  const auto expect_less = [&] (const SegmentPixels& now,
                                const std::vector<float>& was) {
    ASSERT_FALSE (now.pixel.empty());
    for (std::size_t i = 0; i < now.pixel.size(); i += 17) {
      const int width = points.means[0].cols;
      const float mean =
          points.means[0].at<float> (now.pixel[i] / width, now.pixel[i] % width);
      ASSERT_NEAR (now.intensity[i], was[i] - 0.75 * (kGain * mean + kOffset), 1e-5);
    }
  };
  expect_less (points.pixels[0], before);
  expect_less (points.probes, probes);
}

TEST_F (ExposedPair, HasNoMeansUnderAnotherLight)
{
  scene_.change = {kGain, 0.0f, /*local*/ true};
  EXPECT_TRUE (prepared().means[0].empty());
}

} // namespace
