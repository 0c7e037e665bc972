// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <opencv2/core.hpp>

#include <pcl_msf/pinhole_camera.h>

namespace pcl_msf {

/** \brief The frame that a cloud's coordinates are in, told by its pixels: the point p
 * of pixel (u, v) is seen by `camera` at optical_from_cloud * p + offset. */
struct CloudPose {
  PinholeCamera camera;
  Eigen::Matrix3d optical_from_cloud; ///< rows right, down, forward; det -1: mirrored
  Eigen::Vector3d offset;             ///< in the unit of the points
  double error; ///< median distance from the pixels; infinite when there is no answer
};

/** \brief The best pose whose axes are the optical ones in another order and with other
 * signs and whose origin is the camera: two straight lines for each forward axis and
 * order of the rest. Needs no particular geometry.
 * \param points CV_32FC3, as from coordinateImage */
CloudPose
poseByAxes (const cv::Mat& points);

/** \brief Any rotation and offset: the direct linear transformation of the least
 * absolute error. No answer for points in one plane, which fix none. */
CloudPose
poseByProjection (const cv::Mat& points);

} // namespace pcl_msf
