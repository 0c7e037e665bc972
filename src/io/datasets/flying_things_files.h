// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/rigid_pose.h>

#include <map>
#include <optional>
#include <string>

namespace pcl_msf::io {

/** \brief Where the parts of a sequence of FlyingThings3D, Monkaa or Driving are:
 * TOP/KIND/SEQUENCE/[into_future|into_past/]VIEW/FRAME. */
struct FlyingThingsPlace {
  std::string top;
  std::string sequence; ///< e.g. "TRAIN/A/0000"
  std::string view;     ///< "left" or "right"

  std::string
  disparity (const std::string& frame) const;

  std::string
  disparityChange (const std::string& frame, bool future) const;

  std::string
  flow (const std::string& frame, bool future) const;

  std::string
  cameraData () const;
};

/** \brief The place of a folder of colour images, TOP/frames_PASSpass[_webp]/SEQUENCE/
 * VIEW; none for other folders, and for .webp where the .png are there, too. */
std::optional<FlyingThingsPlace>
findFlyingThings (const std::string& folder, const std::string& pass);

/** \brief Reads a one-channel .pfm. \return CV_32FC1, pixels \throws IoError */
cv::Mat
readDisparity (const std::string& path);

/** \brief As readDisparity, of a change of disparity. */
cv::Mat
readDisparityChange (const std::string& path);

/** \brief Reads optical flow, a three-channel .pfm whose third is without meaning.
 * \return CV_32FC2, pixels, NaN = unknown \throws IoError */
cv::Mat
readFlyingThingsFlow (const std::string& path);

/** \brief |disparity + change|; NaN where the sum changes its sign, for there the point
 * is behind the camera. Some releases have all disparities negative. */
cv::Mat
laterDisparity (const cv::Mat& disparity, const cv::Mat& change);

/** \brief Reads a camera_data.txt: "Frame N", then a line "L" and a line "R" of a 4x4
 * matrix each, world from camera with x right, y up, z backwards.
 * \param view 'L' or 'R' \return `world_from_camera` by frame, for a camera with x
 * right, y down, z forward \throws IoError */
std::map<int, RigidPose>
readCameraData (const std::string& path, char view);

} // namespace pcl_msf::io
