// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/export.h>
#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/rigid_pose.h>

#include <string>

namespace pcl_msf::io {

/** \brief Reads an optical flow file (.flo, Middlebury's format).
 *
 * Bytes, little-endian: float 202021.25, int32 width, int32 height, then u v pairs of
 * float32, row by row from the top.
 * \return CV_32FC2, pixels; NaN where unknown (the file has NaN or a magnitude above
 * 1e9) \throws IoError */
PCL_MSF_EXPORT cv::Mat
readFlow (const std::string& path);

/** \brief Writes an optical flow file (.flo). \param flow CV_32FC2, pixels; NaN and inf
 * are written as 1e10 in both components \throws IoError */
PCL_MSF_EXPORT void
writeFlow (const std::string& path, const cv::Mat& flow);

/** \brief Reads a depth file of the Sintel benchmark (.dpt).
 *
 * Bytes, little-endian: float 202021.25, int32 width, int32 height, float32 metres row
 * by row from the top. \return CV_32FC1, metres, as in the file \throws IoError */
PCL_MSF_EXPORT cv::Mat
readDpt (const std::string& path);

/** \brief Writes a .dpt file. \param depth CV_32FC1, metres \throws IoError */
PCL_MSF_EXPORT void
writeDpt (const std::string& path, const cv::Mat& depth);

/** \brief Reads a portable float map (.pfm, "Pf" or "PF"), either byte order.
 *
 * \return CV_32FC1 or CV_32FC3 with row 0 on top and the channels in file order (other
 * than cv::imread, which swaps them). The header's scale gives the byte order only; the
 * values are those of the file. \throws IoError */
PCL_MSF_EXPORT cv::Mat
readPfm (const std::string& path);

/** \brief Writes a little-endian .pfm. \param image CV_32FC1 or CV_32FC3 \throws
 * IoError
 */
PCL_MSF_EXPORT void
writePfm (const std::string& path, const cv::Mat& image);

/** \brief Reads a camera file of the Sintel benchmark (.cam), see writeCam.
 *
 * \param[out] camera_from_world the extrinsic matrix, metres \return the camera, pixels
 * \throws IoError, also when the matrices are no pinhole camera and no rigid motion */
PCL_MSF_EXPORT PinholeCamera
readCam (const std::string& path, RigidPose& camera_from_world);

/** \brief Writes a camera file of the Sintel benchmark (.cam).
 *
 * Bytes, little-endian: float 202021.25, then row by row the intrinsic 3x3 and the
 * extrinsic 3x4 (camera from world, metres) as float64. \throws IoError */
PCL_MSF_EXPORT void
writeCam (const std::string& path,
          const PinholeCamera& camera,
          const RigidPose& camera_from_world);

} // namespace pcl_msf::io
