// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/frame/light_change.h"

#include <cmath>
#include <functional>
#include <random>

namespace {

using namespace pcl_msf;

/** Current intensity from that of the reference and its place, besides noise of one
 * grey value and a quarter of wrong pairs. */
MatchedIntensities
matched (const std::function<double (double i, double x, double y)>& current,
         int count = 4000)
{
  std::mt19937 generator (3);
  std::uniform_real_distribution<double> uniform (0.1, 0.8);
  std::uniform_real_distribution<double> place (-1.0, 1.0);
  std::normal_distribution<double> noise (0.0, 0.004);
  MatchedIntensities matches;
  for (int k = 0; k < count; ++k) {
    const double i = uniform (generator);
    const double x = place (generator);
    const double y = place (generator);
    const double right = current (i, x, y) + noise (generator);
    matches.reference.push_back (static_cast<float> (i));
    matches.current.push_back (
        static_cast<float> (place (generator) < -0.5 ? uniform (generator) : right));
    matches.x.push_back (static_cast<float> (x));
    matches.y.push_back (static_cast<float> (y));
  }
  return matches;
}

bool
found (const MatchedIntensities& matches)
{
  return fitBrightnessChange (matches, {}).local;
}

TEST (LightChange, ExposureAloneIsNone)
{
  EXPECT_FALSE (found (matched ([] (double i, double, double) { return i; })));
  EXPECT_FALSE (
      found (matched ([] (double i, double, double) { return 0.8 * i + 0.05; })));
  EXPECT_FALSE (found ({}));
  EXPECT_FALSE (found (
      matched ([] (double i, double x, double) { return i * (1 + 0.1 * x); }, 99)))
      << "too few pairs";
}

TEST (LightChange, OfAFewGreyValuesIsFound)
{
  const auto falloff = [] (double i, double x, double y) {
    return i * (1.0 - 0.1 * (x * x + y * y));
  };
  const auto response = [] (double i, double, double) { return std::pow (i, 1.25); };
  const auto lamp = [] (double i, double x, double y) {
    return i + 0.06 * std::sin (1.5 * x + 1.0) * std::cos (1.25 * y);
  };
  EXPECT_TRUE (found (matched (falloff)));
  EXPECT_TRUE (found (matched (response)));
  EXPECT_TRUE (found (matched (lamp)));
  EXPECT_EQ (fitBrightnessChange (matched (lamp), {}).offset, 0.0f);
}

TEST (LocalContrast, LeavesWhatIsSmallerThanItsRadius)
{
  cv::Mat image (40, 50, CV_32FC1);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      image.at<float> (y, x) = 0.3f + 0.002f * static_cast<float> (x + 2 * y);
  image.at<float> (20, 30) += 0.49f;
  const cv::Mat contrast = localContrast (image, 3);
  // The slope is gone but at the border; the point less its own share of 49 pixels.
  EXPECT_NEAR (contrast.at<float> (20, 30), 0.48f, 1e-5f);
  EXPECT_NEAR (contrast.at<float> (20, 33), -0.01f, 1e-5f);
  EXPECT_NEAR (contrast.at<float> (20, 34), 0.0f, 1e-5f);
  EXPECT_NEAR (contrast.at<float> (8, 10), 0.0f, 1e-5f);
  EXPECT_TRUE (localContrast ({}, 3).empty());
}

} // namespace
