// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/frame/brightness_change.h"

#include <random>

namespace {

using namespace pcl_msf;

struct Pairs {
  std::vector<float> reference, current;
};

Pairs
matched (double gain, double offset, double wrong, int count)
{
  std::mt19937 generator (3);
  std::uniform_real_distribution<double> uniform (0.1, 0.8);
  std::normal_distribution<double> normal (0.0, 0.005);
  Pairs pairs;
  for (int i = 0; i < count; ++i) {
    const double a = uniform (generator);
    const double right = gain * a + offset + normal (generator);
    const double b = i < wrong * count ? uniform (generator) : right;
    pairs.reference.push_back (static_cast<float> (a));
    pairs.current.push_back (static_cast<float> (b));
  }
  return pairs;
}

class Exposure : public testing::TestWithParam<std::tuple<double, double, double>> {};

TEST_P (Exposure, GainAndOffsetAreFoundAmongWrongPairs)
{
  const auto [gain, offset, wrong] = GetParam();
  const Pairs pairs = matched (gain, offset, wrong, 4000);
  const BrightnessChange found = fitExposureChange (pairs.reference, pairs.current, {});
  // Right to one grey value of 255 over the range of intensities; with wrong pairs to
  // two and a half.
  for (const double i : {0.1, 0.45, 0.8})
    EXPECT_NEAR (
        found.gain * i + found.offset, gain * i + offset, wrong > 0 ? 0.01 : 0.004)
        << i;
}

INSTANTIATE_TEST_SUITE_P (GainsOffsetsAndWrongPairs,
                          Exposure,
                          testing::Combine (testing::Values (0.8, 1.0, 1.2),
                                            testing::Values (-0.05, 0.0, 0.1),
                                            testing::Values (0.0, 0.3)));

TEST (BrightnessChange, FewPairsSayNothing)
{
  const Pairs pairs = matched (1.3, 0.1, 0.0, 99);
  const BrightnessChange found = fitExposureChange (pairs.reference, pairs.current, {});
  EXPECT_EQ (found.gain, 1.0f);
  EXPECT_EQ (found.offset, 0.0f);
  EXPECT_EQ (fitExposureChange ({}, {}, {}).gain, 1.0f);
}

TEST (BrightnessChange, WithoutContrastThereIsNoGain)
{
  const std::vector<float> gray (500, 0.4f);
  const BrightnessChange same = fitExposureChange (gray, gray, {});
  EXPECT_EQ (same.gain, 1.0f);
  EXPECT_NEAR (same.offset, 0.0f, 1e-6f);
  const BrightnessChange brighter =
      fitExposureChange (gray, std::vector<float> (500, 0.5f), {});
  EXPECT_EQ (brighter.gain, 1.0f);
  EXPECT_NEAR (brighter.offset, 0.1f, 1e-6f);
}

TEST (BrightnessChange, GainStaysWithinReason)
{
  const Pairs pairs = matched (5.0, -0.4, 0.0, 1000);
  const BrightnessChange found = fitExposureChange (pairs.reference, pairs.current, {});
  EXPECT_LE (found.gain, 2.0f);
  EXPECT_GE (found.gain, 0.5f);
}

} // namespace
