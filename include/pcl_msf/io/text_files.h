// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/lens_distortion.h>
#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/rigid_pose.h>

#include <string>

namespace pcl_msf::io {

/** \brief Writes a text file, whole or not at all. \throws IoError */
PCL_MSF_EXPORT void
writeText (const std::string& path, const std::string& text);

/** \brief What a camera.txt says. */
struct CameraFile {
  PinholeCamera camera;        ///< pixels
  int width{0};                ///< of the images, pixels
  int height{0};               ///< of the images, pixels
  double depth_scale{1.0};     ///< 16-bit depth units per metre, > 0
  LensDistortion distortion{}; ///< of the images
};

/** \brief Reads a camera.txt: `fx fy cx cy width height depth_scale`, parted by white
 * space, and, when the images are distorted, `k1 k2 p1 p2` or `k1 k2 p1 p2 k3`. \throws
 * IoError for fields that are missing, no numbers, or no camera */
PCL_MSF_EXPORT CameraFile
readCamera (const std::string& path);

/** \brief Writes a camera.txt that `readCamera` reads back exactly. \throws IoError */
PCL_MSF_EXPORT void
writeCamera (const std::string& path, const CameraFile& file);

/** \brief Reads a homogeneous 4x4 matrix, row by row, as a rigid motion.
 * \throws IoError for fields that are missing, no numbers, or no rigid motion (rotation
 * further than 1e-3 from orthonormal) */
PCL_MSF_EXPORT RigidPose
readPose (const std::string& path);

/** \brief Writes a pose as a 4x4 matrix. \throws IoError */
PCL_MSF_EXPORT void
writePose (const std::string& path, const RigidPose& pose);

} // namespace pcl_msf::io
