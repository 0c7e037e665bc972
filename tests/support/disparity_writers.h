// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "support/format_bytes.h"
#include "support/small_sequence.h"

// A generated sequence in the formats that store depth as disparity.
namespace pcl_msf::testing {

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
laterDepth (const cv::Mat& depth, const synthetic::GroundTruth& truth)
{
  cv::Mat z;
  cv::extractChannel (truth.scene_flow, z, 2);
  return depth + z;
}

/** \brief FlyingThings3D, frames 6 and so on of TRAIN/A/0000, left, clean. */
inline void
writeFlyingThings (const synthetic::SyntheticSequence& sequence, const std::string& top)
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
    const synthetic::GroundTruth& truth = sequence.successive_truth[k];
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
writeKitti (const synthetic::SyntheticSequence& sequence,
            const std::string& top,
            double baseline)
{
  const PinholeCamera& c = sequence.camera;
  const double fb = c.fx * baseline;
  const synthetic::GroundTruth& truth = sequence.truth[1];
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
