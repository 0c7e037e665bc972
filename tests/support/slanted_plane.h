// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "support/points.h"
#include <pcl_msf/pinhole_camera.h>

namespace pcl_msf::test {

/** \brief Small depth images whose surfaces are known. */
struct SlantedPlane {
  static constexpr int kWidth = 96;
  static constexpr int kHeight = 80;
  PinholeCamera camera{100.0, 98.0, 47.0, 40.5};
  Eigen::Vector3d normal{Eigen::Vector3d (0.35, -0.5, -1.0).normalized()};

  /** \brief Depth of the plane normal . p = -1.8. */
  cv::Mat
  depth () const
  {
    return image (kWidth, kHeight, [this] (int x, int y) {
      return -1.8 / normal.dot (camera.backProject (x, y, 1.0));
    });
  }

  static cv::Mat
  constant (double value)
  {
    return cv::Mat (kHeight, kWidth, CV_32FC1, cv::Scalar (value));
  }

  /** \brief A near half on the left, a far one on the right. */
  static cv::Mat
  step (double near, double far, int edge)
  {
    return image (kWidth, kHeight, [&] (int x, int) { return x < edge ? near : far; });
  }
};

} // namespace pcl_msf::test
