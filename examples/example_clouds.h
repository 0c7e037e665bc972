// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <pcl_msf/synthetic/synthetic_sequence.h>

// What the examples work on in place of a sensor: a generated arm that bends, in
// clouds.

using Cloud = pcl::PointCloud<pcl::PointXYZRGBA>;

/** Four frames of 160 x 120 pixels. */
inline const pcl_msf::synthetic::SyntheticSequence&
exampleSequence ()
{
  static const auto sequence = [] {
    pcl_msf::synthetic::SequenceOptions options;
    options.scene = pcl_msf::synthetic::SceneKind::Articulated;
    options.width = 160;
    options.height = 120;
    options.frames = 4;
    return pcl_msf::synthetic::synthesize (options);
  }();
  return sequence;
}

/** A frame as an organized cloud: x right, y down, z forward, metres. */
inline Cloud::Ptr
exampleCloud (int frame)
{
  const auto& sequence = exampleSequence();
  const auto& images = sequence.frames.at (frame);
  auto cloud = pcl::make_shared<Cloud> (images.depth.cols, images.depth.rows);
  for (int v = 0; v < images.depth.rows; ++v)
    for (int u = 0; u < images.depth.cols; ++u) {
      auto& point = (*cloud) (u, v);
      const cv::Vec3b bgr = images.color.at<cv::Vec3b> (v, u);
      point.getVector3fMap() =
          sequence.camera.backProject (u, v, images.depth.at<float> (v, u))
              .cast<float>();
      point.b = bgr[0], point.g = bgr[1], point.r = bgr[2];
    }
  cloud->is_dense = false; // a point without depth is NaN
  return cloud;
}
