// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <Eigen/Core>

#include "core/segments/surface_links.h"

#include <cstdint>

namespace {

using namespace pcl_msf;

constexpr double kNoise = 1e-4; // of inverse depth

/** Four vertical strips of 10 pixels; the last two lie one metre behind the others. */
class SurfaceLinks : public testing::Test {
protected:
  SurfaceLinks()
  {
    level_.inverse_depth.create (20, 40, CV_32FC1);
    labels_.create (20, 40, CV_32SC1);
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 40; ++x) {
        labels_.at<std::int32_t> (y, x) = x / 10;
        level_.inverse_depth.at<float> (y, x) = x < 20 ? 0.5f : 1.0f / 3.0f;
      }
  }

  void
  link (int first, int second)
  {
    links_.push_back ({first, second, Eigen::Vector3d::Zero(), 0.1});
  }

  /** Strength of a link by that of the first one. */
  double
  relative (std::size_t i) const
  {
    return links_[i].strength / links_[0].strength;
  }

  FrameLevel level_;
  cv::Mat labels_;
  std::vector<SegmentLink> links_;
};

TEST_F (SurfaceLinks, AStepHardlyBindsAndTheMeanIsOne)
{
  link (0, 1);
  link (1, 2); // the step
  link (2, 3);
  link (0, 3); // they do not touch
  weighLinksBySurface (labels_, level_, kNoise, {}, links_);
  EXPECT_DOUBLE_EQ (relative (2), 1.0);
  EXPECT_LT (relative (1), 0.1);
  EXPECT_GT (relative (1), 0.0);
  EXPECT_DOUBLE_EQ (relative (3), relative (1));
  double sum = 0.0;
  for (const SegmentLink& l : links_)
    sum += l.strength;
  EXPECT_NEAR (sum, 4.0, 1e-12);
}

TEST_F (SurfaceLinks, ABorderThatIsHalfAStepBindsHalf)
{
  for (int y = 0; y < 10; ++y)
    level_.inverse_depth.row (y).colRange (20, 40).setTo (0.5f);
  link (0, 1);
  link (1, 2);
  weighLinksBySurface (labels_, level_, kNoise, {}, links_);
  EXPECT_NEAR (relative (1), 0.5, 0.05);
}

TEST_F (SurfaceLinks, ASlopeIsNoStep)
{
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x)
      level_.inverse_depth.at<float> (y, x) = 0.5f - 0.002f * static_cast<float> (x);
  link (0, 1);
  link (1, 2);
  weighLinksBySurface (labels_, level_, kNoise, {}, links_);
  EXPECT_DOUBLE_EQ (relative (1), 1.0);
}

TEST_F (SurfaceLinks, NoiseIsNoStep)
{
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x)
      level_.inverse_depth.at<float> (y, x) = 0.5f + ((x + y) % 2 ? 0.01f : -0.01f);
  link (0, 1);
  link (1, 2);
  weighLinksBySurface (labels_, level_, 0.01, {}, links_);
  EXPECT_DOUBLE_EQ (links_[0].strength, 1.0);
  EXPECT_DOUBLE_EQ (relative (1), 1.0);
}

TEST_F (SurfaceLinks, WithoutASurfaceInCommonAllCountTheSame)
{
  labels_.setTo (-1);
  link (0, 1);
  link (1, 2);
  weighLinksBySurface (labels_, level_, kNoise, {}, links_);
  EXPECT_DOUBLE_EQ (links_[0].strength, 1.0);
  EXPECT_DOUBLE_EQ (links_[1].strength, 1.0);
}

TEST_F (SurfaceLinks, NoLinksAreFine)
{
  weighLinksBySurface (labels_, level_, kNoise, {}, links_);
  EXPECT_TRUE (links_.empty());
}

} // namespace
