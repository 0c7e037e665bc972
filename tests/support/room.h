// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <gtest/gtest.h>

#include "support/analytic_scene.h"
#include <pcl_msf/scene_flow_estimator.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_msf {
namespace test {

/** The room with the moving box, and what the estimator makes of it. */
class Room : public ::testing::Test {
protected:
  Room()
  {
    view_.depth (kHole) = std::nanf ("");
    reference_ = scene_.frame (view_);
    current_ = scene_.frame (scene_.render (true));
    SegmentationParameters cut;
    cut.segment_size = 16;
    segments_ = Oversegmentation::fromFrame (reference_, cut);
  }

  /** One thread where the test does not ask for more. */
  static SolverParameters
  alone ()
  {
    SolverParameters solver;
    solver.threads = 1;
    return solver;
  }

  SceneFlow
  estimate (const SolverParameters& solver = alone(), const RigidPose& guess = {}) const
  {
    return SceneFlowEstimator ({}, solver)
        .estimate (reference_, current_, segments_, guess);
  }

  /** End-point errors of the points seen in both frames, sorted. */
  std::vector<double>
  errors (const SceneFlow& result, int body = -1) const
  {
    const Truth truth = scene_.truth (view_);
    std::vector<double> errors;
    for (int y = 0; y < scene_.height; ++y)
      for (int x = 0; x < scene_.width; ++x) {
        const bool wanted = body < 0 || view_.body.at<int> (y, x) == body;
        if (!truth.visible.at<unsigned char> (y, x) || !wanted ||
            kHole.contains ({x, y}))
          continue;
        const double error = cv::norm (result.flow.at<cv::Vec2f> (y, x) -
                                       truth.flow.at<cv::Vec2f> (y, x));
        errors.push_back (std::isfinite (error) ? error : 100.0);
      }
    std::sort (errors.begin(), errors.end());
    return errors;
  }

  static double
  mean (const std::vector<double>& values)
  {
    double sum = 0.0;
    for (const double v : values)
      sum += v;
    return sum / static_cast<double> (values.size());
  }

  const cv::Rect kHole{20, 30, 9, 7};
  AnalyticScene scene_{roomWithBox()};
  View view_{scene_.render (false)};
  RgbdFrame reference_, current_;
  Oversegmentation segments_;
};

} // namespace test
} // namespace pcl_msf
