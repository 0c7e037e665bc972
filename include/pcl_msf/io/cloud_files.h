// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <pcl_msf/io/rgbd_images.h>

#include <optional>
#include <string>

namespace pcl_msf::io {

/** \brief Reads an organized cloud from a .pcd file (ascii, binary or compressed).
 *
 * Fields x y z are required (metres, camera frame, NaN = no point); rgb, rgba or
 * intensity give the colour (intensity in [0, 1] or 0 .. 255), others are ignored. With
 * colour every point's alpha is 255, without any it is 0.
 * \throws IoError for anything else, unorganized clouds included */
pcl::PointCloud<pcl::PointXYZRGBA>::Ptr
readOrganizedCloud (const std::string& path);

/** \brief Reads an organized cloud as images.
 *
 * \param camera of the cloud's sensor; when not given it is fitted to the points, which
 * takes points with depth spread over the image \throws IoError */
RgbdImages
readCloudImages (const std::string& path,
                 const std::optional<PinholeCamera>& camera = {});

/** \brief Fits the pinhole camera that sees an organized cloud's points at their
 * pixels.
 *
 * Least squares of u = fx x/z + cx and v = fy y/z + cy over all finite points, which is
 * determined for flat scenes, too. \throws IoError naming `path` when the points do not
 * tell, or lie more than 2 px (RMS) off their pixels: then the camera must be given */
PinholeCamera
fitCamera (const pcl::PointCloud<pcl::PointXYZRGBA>& cloud, const std::string& path);

} // namespace pcl_msf::io
