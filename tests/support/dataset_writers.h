// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "support/format_bytes.h"
#include <pcl_msf/synthetic/synthetic_sequence.h>

#include <algorithm>

// A generated sequence in the formats of data sets that the library only reads.
namespace pcl_msf::testing {

/** \brief Three frames of moving bodies, 96x72, without noise. */
inline const SyntheticSequence&
smallSequence ()
{
  static const SyntheticSequence sequence = [] {
    SequenceOptions options;
    options.scene = Scene::MultiBody;
    options.width = 96;
    options.height = 72;
    options.frames = 3;
    options.successive_truth = true;
    return synthesize (options);
  }();
  return sequence;
}

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
writeVirtualKitti1 (const SyntheticSequence& sequence, const std::string& top)
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
writeVirtualKitti2 (const SyntheticSequence& sequence,
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
    const GroundTruth& truth = sequence.successive_truth[i];
    const int k = static_cast<int> (i);
    putImage (image ("forwardFlow", "flow_", k), virtualKittiFlow (truth.flow));
    putImage (image ("forwardSceneFlow", "sceneFlow_", k),
              virtualKittiSceneFlow (truth.scene_flow));
  }
  putText (place ("textgt") + "intrinsic.txt", intrinsic.str());
  putText (place ("textgt") + "extrinsic.txt", extrinsic.str());
}

/** \brief Disparity of a depth image; 0 where there is none. */
inline cv::Mat
disparityOf (const cv::Mat& depth, double focal_times_baseline)
{
  cv::Mat disparity (depth.size(), CV_32FC1, cv::Scalar (0));
  for (int row = 0; row < depth.rows; ++row)
    for (int col = 0; col < depth.cols; ++col)
      if (const float z = depth.at<float> (row, col); std::isfinite (z))
        disparity.at<float> (row, col) = static_cast<float> (focal_times_baseline / z);
  return disparity;
}

/** \brief Depth of each point of a frame in the next one. */
inline cv::Mat
laterDepth (const cv::Mat& depth, const GroundTruth& truth)
{
  cv::Mat z;
  cv::extractChannel (truth.scene_flow, z, 2);
  return depth + z;
}

/** \brief FlyingThings3D, frames 6 and so on of TRAIN/A/0000, left, clean. */
inline void
writeFlyingThings (const SyntheticSequence& sequence, const std::string& top)
{
  const std::string name = "/TRAIN/A/0000";
  const RigidPose half_turn{{std::acos (-1.0), 0.0, 0.0, 0.0, 0.0, 0.0}};
  std::ostringstream poses;
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    const int number = static_cast<int> (k) + 6;
    const cv::Mat disparity =
        disparityOf (sequence.frames[k].depth, sequence.camera.fx);
    putImage (numbered (top + "/frames_cleanpass" + name + "/left/", number, 4, ".png"),
              sequence.frames[k].color);
    putPfm (numbered (top + "/disparity" + name + "/left/", number, 4, ".pfm"),
            disparity);
    const std::string matrix =
        matrixText (sequence.frame0_from_framek[k] * half_turn, true);
    poses << "Frame " << number << "\nL " << matrix << "\nR " << matrix << "\n\n";
    if (k >= sequence.successive_truth.size())
      continue;
    const GroundTruth& truth = sequence.successive_truth[k];
    const cv::Mat later =
        disparityOf (laterDepth (sequence.frames[k].depth, truth), sequence.camera.fx);
    putPfm (
        numbered (
            top + "/disparity_change" + name + "/into_future/left/", number, 4, ".pfm"),
        later - disparity);
    const std::vector<cv::Mat> planes{
        truth.flow, cv::Mat (disparity.size(), CV_32FC1, cv::Scalar (0))};
    cv::Mat flow;
    cv::merge (planes, flow);
    putPfm (numbered (top + "/optical_flow" + name +
                          "/into_future/left/OpticalFlowIntoFuture_",
                      number,
                      4,
                      "_L.pfm"),
            flow);
  }
  putText (top + "/camera_data" + name + "/camera_data.txt", poses.str());
}

/** \brief KITTI's flow: 64 u + 2^15 in red, v in green, blue 1 = known. */
inline cv::Mat
kittiFlow (const cv::Mat& flow, const cv::Mat& known)
{
  cv::Mat image (flow.size(), CV_16UC3, cv::Scalar (0, 0, 0));
  const auto encode = [] (double value) {
    return static_cast<std::uint16_t> (std::lround (value * 64.0 + 32768.0));
  };
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col) {
      const auto f = flow.at<cv::Vec2f> (row, col);
      if (std::isfinite (f[0]) && known.at<unsigned char> (row, col) != 0)
        image.at<cv::Vec3w> (row, col) = {1, encode (f[1]), encode (f[0])};
    }
  return image;
}

/** \brief KITTI 2015, scene 000007 with dense disparities in disp_0 and disp_1. */
inline void
writeKitti (const SyntheticSequence& sequence, const std::string& top, double baseline)
{
  const PinholeCamera& c = sequence.camera;
  const double fb = c.fx * baseline;
  const GroundTruth& truth = sequence.truth[1];
  const std::string first = "/000007_10.png", second = "/000007_11.png";
  const cv::Mat all (truth.flow.size(), CV_8UC1, cv::Scalar (255));
  const cv::Mat d0 = disparityOf (sequence.frames[0].depth, fb);
  putImage (top + "/image_2" + first, sequence.frames[0].color);
  putImage (top + "/image_2" + second, sequence.frames[1].color);
  putImage (top + "/disp_0" + first, units (d0, 256.0));
  putImage (top + "/disp_1" + second,
            units (disparityOf (sequence.frames[1].depth, fb), 256.0));
  putImage (top + "/disp_occ_0" + first, units (d0, 256.0));
  putImage (
      top + "/disp_occ_1" + first,
      units (disparityOf (laterDepth (sequence.frames[0].depth, truth), fb), 256.0));
  putImage (top + "/flow_occ" + first, kittiFlow (truth.flow, all));
  putImage (top + "/flow_noc" + first, kittiFlow (truth.flow, truth.visible));
  cv::Mat labels;
  sequence.labels.convertTo (labels, CV_8U);
  putImage (top + "/obj_map" + first, labels);
  std::ostringstream calibration;
  calibration << std::setprecision (12) << "calib_time: 09-Jan-2012 13:57:47\n"
              << "S_rect_02: 96 72\n"
              << "P_rect_02: " << c.fx << " 0 " << c.cx << " 44.8 0 " << c.fy << ' '
              << c.cy << " 0.2 0 0 1 0.003\n"
              << "P_rect_03: " << c.fx << " 0 " << c.cx << ' ' << 44.8 - fb << " 0 "
              << c.fy << ' ' << c.cy << " 2.2 0 0 1 0.003\n";
  putText (top + "/calib_cam_to_cam/000007.txt", calibration.str());
}

} // namespace pcl_msf::testing
