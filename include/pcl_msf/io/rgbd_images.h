// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/lens_distortion.h>
#include <pcl_msf/pinhole_camera.h>

#include <array>
#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief Where the sensor stood in the world, the VIEWPOINT of a .pcd and the sensor
 * pose of a pcl::PointCloud. Nothing is computed with it: it goes from a frame to the
 * clouds made of it, so that viewers show them in one place. */
struct Viewpoint {
  std::array<float, 3> origin{0, 0, 0};         ///< metres
  std::array<float, 4> orientation{1, 0, 0, 0}; ///< quaternion, w x y z
};

/** \brief One RGB-D picture as RgbdFrame::fromImages takes it. */
struct RgbdImages {
  cv::Mat color;         ///< CV_8UC1 or CV_8UC3 (BGR); empty = geometry only
  cv::Mat depth;         ///< CV_32FC1, metres; 0, NaN, inf or negative = none
  PinholeCamera camera;  ///< of both, pixels
  Viewpoint viewpoint{}; ///< as the cloud's file says; images have none

  /** \brief What `color` was made of when the file has no bytes but numbers of a range
   * of its own (intensities of ToF cameras, lidars, infrared; colours as floats):
   * CV_32FC1 or CV_32FC3 (BGR), as in the file; empty otherwise. See unifyColors. */
  cv::Mat raw_color{};

  /** \brief What the images were freed from when they were loaded, see undistort;
   * `camera` is the one without it. */
  LensDistortion distortion{};

  /** \brief What of the file was not used, and why; empty when all was. */
  std::string note{};
};

/** \brief The unit of the frames' raw colours: what stands for full brightness when all
 * of them are brought to one range by pcl_msf::normalizeIntensity. 1 without any. */
PCL_MSF_EXPORT double
colorUnit (const std::vector<const RgbdImages*>& frames);

/** \brief Makes `color` anew from `raw_color`: 255 for `unit` and more, CV_8UC3.
 * Nothing happens to a frame without raw colours. \param unit > 0 */
PCL_MSF_EXPORT void
setColorUnit (RgbdImages& frame, double unit);

/** \brief Brings frames that are compared to one unit. A reader sees one frame alone
 * and takes that frame's; where maxima differ, brightness would differ with them. */
PCL_MSF_EXPORT void
unifyColors (const std::vector<RgbdImages*>& frames);

} // namespace pcl_msf::io
