// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/imgproc.hpp>

#include "support/analytic_scene.h"

#include <random>

namespace pcl_msf::test {

/** Another room: about as deep as a scene, with a pattern of its own on everything. */
inline RgbdFrame
otherPlace (AnalyticScene scene)
{
  for (Quad& quad : scene.quads)
    quad.corner += Eigen::Vector3d (0.4, -0.2, 0.3);
  View view = scene.render (true);
  std::mt19937 random (2);
  std::uniform_real_distribution<float> bright (0.0f, 1.0f);
  for (int y = 0; y < view.color.rows; y += 4)
    for (int x = 0; x < view.color.cols; x += 4)
      view.color (cv::Rect (x, y, 4, 4)) = bright (random);
  cv::GaussianBlur (view.color, view.color, {}, 1.0);
  return scene.frame (view);
}

} // namespace pcl_msf::test
