// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include "support/temporary_folder.h"
#include <pcl_msf/io/images.h>
#include <pcl_msf/pinhole_camera.h>

#include <cmath>
#include <string>

namespace pcl_msf::testing {

/** \brief Two pictures of a textured wall with a box before it, for the tool's tests.
 * The camera stands still; from the first to the second frame the box moves to the
 * right. */
struct SmallScene {
  static constexpr int kWidth = 160;
  static constexpr int kHeight = 120;
  static constexpr int kBoxShift = 3; ///< pixels

  PinholeCamera camera{150.0, 150.0, 79.5, 59.5};

  static double
  texture (double u, double v)
  {
    return 120.0 + 40.0 * std::sin (0.5 * u + 0.3 * v) +
           35.0 * std::sin (0.23 * u * v / 40) + 30.0 * std::cos (0.4 * v - 0.2 * u);
  }

  static bool
  inBox (int col, int row, int shift)
  {
    return col >= 50 + shift && col < 100 + shift && row >= 40 && row < 90;
  }

  static cv::Mat
  color (int frame)
  {
    const int shift = frame * kBoxShift;
    cv::Mat image (kHeight, kWidth, CV_8UC3);
    for (int row = 0; row < kHeight; ++row)
      for (int col = 0; col < kWidth; ++col) {
        const double value = inBox (col, row, shift) ? texture (row + 31, col - shift)
                                                     : texture (col, row);
        image.at<cv::Vec3b> (row, col) =
            cv::Vec3b::all (cv::saturate_cast<unsigned char> (value));
      }
    return image;
  }

  static cv::Mat
  depth (int frame)
  {
    cv::Mat image (kHeight, kWidth, CV_32FC1, cv::Scalar (2.0));
    for (int row = 0; row < kHeight; ++row)
      for (int col = 0; col < kWidth; ++col)
        if (inBox (col, row, frame * kBoxShift))
          image.at<float> (row, col) = 1.0F;
    image (cv::Rect (0, 0, 10, 10)).setTo (0.0F);
    return image;
  }

  void
  writeImages (const TemporaryFolder& folder) const
  {
    for (const int frame : {0, 1}) {
      const std::string k = std::to_string (frame);
      io::writeImage (folder ("c" + k + ".png"), color (frame));
      io::writeDepth (folder ("d" + k + ".png"), depth (frame), 5000.0);
    }
  }

  void
  writeClouds (const TemporaryFolder& folder) const
  {
    for (const int frame : {0, 1}) {
      const cv::Mat bgr = color (frame);
      const cv::Mat z = depth (frame);
      pcl::PointCloud<pcl::PointXYZRGB> cloud (kWidth, kHeight);
      for (int row = 0; row < kHeight; ++row)
        for (int col = 0; col < kWidth; ++col) {
          const float metres = z.at<float> (row, col);
          auto& point = cloud (col, row);
          point.getVector3fMap() =
              camera.backProject (col, row, metres > 0 ? metres : NAN).cast<float>();
          point.r = point.g = point.b = bgr.at<cv::Vec3b> (row, col)[0];
        }
      cloud.is_dense = false;
      cloud.sensor_origin_ = {frame + 1.0F, 0.0F, 0.0F, 0.0F};
      pcl::io::savePCDFileBinary (folder ("k" + std::to_string (frame) + ".pcd"),
                                  cloud);
    }
  }
};

} // namespace pcl_msf::testing
