// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "support/format_bytes.h"
#include "support/small_sequence.h"

#include <algorithm>

// A generated sequence as Virtual KITTI has it.
namespace pcl_msf::testing {

/** \brief 16 bit of a value in [-range, range]. */
inline std::uint16_t
symmetric (double value, double range)
{
  const double unit = std::clamp (0.5 * (value / range + 1.0), 0.0, 1.0);
  return static_cast<std::uint16_t> (std::lround (unit * 65535.0));
}

/** \brief Virtual KITTI's flow: blue 65535 = known, green v, red u. */
inline cv::Mat
virtualKittiFlow (const cv::Mat& flow)
{
  cv::Mat image (flow.size(), CV_16UC3, cv::Scalar (0, 0, 0));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const auto f = flow.at<cv::Vec2f> (row, col);
      if (std::isfinite (f[0]))
        image.at<cv::Vec3w> (row, col) = {65535,
                                          symmetric (f[1], flow.rows - 1.0),
                                          symmetric (f[0], flow.cols - 1.0)};
    }
  return image;
}

/** \brief Virtual KITTI 2's scene flow: red x, green y, blue z of 10 m. */
inline cv::Mat
virtualKittiSceneFlow (const cv::Mat& scene_flow)
{
  cv::Mat image (scene_flow.size(), CV_16UC3, cv::Scalar (0, 0, 0));
  for (int row = 0; row < image.rows; ++row)
    for (int col = 0; col < image.cols; ++col) {
      const auto d = scene_flow.at<cv::Vec3f> (row, col);
      if (std::isfinite (d[0]))
        image.at<cv::Vec3w> (row, col) = {
            symmetric (d[2], 10.0), symmetric (d[1], 10.0), symmetric (d[0], 10.0)};
    }
  return image;
}

/** \brief Version 1.3.1, world 0001, variation clone. */
inline void
writeVirtualKitti1 (const synthetic::SyntheticSequence& sequence,
                    const std::string& top)
{
  const auto image = [&top] (const std::string& part, std::size_t k) {
    return numbered (top + "/vkitti_1.3.1_" + part + "/0001/clone/",
                     static_cast<int> (k),
                     5,
                     ".png");
  };
  std::ostringstream poses;
  poses << "frame r1,1 r1,2 r1,3 t1 r2,1 r2,2 r2,3 t2 r3,1 r3,2 r3,3 t3 0 0 0 1\n";
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    putImage (image ("rgb", k), sequence.frames[k].color);
    putImage (image ("depthgt", k), units (sequence.frames[k].depth, 100.0));
    poses << k << ' ' << matrixText (sequence.frame0_from_framek[k].inverse(), true)
          << '\n';
  }
  for (std::size_t k = 0; k < sequence.successive_truth.size(); ++k)
    putImage (image ("flowgt", k),
              virtualKittiFlow (sequence.successive_truth[k].flow));
  putText (top + "/vkitti_1.3.1_extrinsicsgt/0001_clone.txt", poses.str());
}

/** \brief Version 2, Scene01, clone. \param archives one top folder for each kind of
 * data, as downloaded, or else all in one */
inline void
writeVirtualKitti2 (const synthetic::SyntheticSequence& sequence,
                    const std::string& top,
                    bool archives)
{
  const auto place = [&] (const std::string& archive) {
    return top + (archives ? "/vkitti_2.0.3_" + archive : "") + "/Scene01/clone/";
  };
  const auto image = [&] (const std::string& kind, const std::string& stem, int k) {
    return numbered (place (kind) + "frames/" + kind + "/Camera_0/" + stem,
                     k,
                     5,
                     kind == "rgb" ? ".jpg" : ".png");
  };
  const PinholeCamera& c = sequence.camera;
  std::ostringstream intrinsic, extrinsic;
  intrinsic << std::setprecision (12)
            << "frame cameraID K[0,0] K[1,1] K[0,2] K[1,2]\r\n";
  extrinsic << "frame cameraID r1,1 r1,2 r1,3 t1 r2,1 r2,2 r2,3 t2 r3,1 r3,2 r3,3 t3 0 "
               "0 0 1\r\n";
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    const int k = static_cast<int> (i);
    putImage (image ("rgb", "rgb_", k), sequence.frames[i].color);
    putImage (image ("depth", "depth_", k), units (sequence.frames[i].depth, 100.0));
    for (int camera = 0; camera < 2; ++camera) {
      intrinsic << k << ' ' << camera << ' ' << c.fx << ' ' << c.fy << ' '
                << c.cx + 3.0 * camera << ' ' << c.cy << " \r\n";
      extrinsic << k << ' ' << camera << ' '
                << matrixText (sequence.frame0_from_framek[i].inverse(), true)
                << "\r\n";
    }
  }
  for (std::size_t i = 0; i < sequence.successive_truth.size(); ++i) {
    const synthetic::GroundTruth& truth = sequence.successive_truth[i];
    const int k = static_cast<int> (i);
    putImage (image ("forwardFlow", "flow_", k), virtualKittiFlow (truth.flow));
    putImage (image ("forwardSceneFlow", "sceneFlow_", k),
              virtualKittiSceneFlow (truth.scene_flow));
  }
  putText (place ("textgt") + "intrinsic.txt", intrinsic.str());
  putText (place ("textgt") + "extrinsic.txt", extrinsic.str());
}

} // namespace pcl_msf::testing
