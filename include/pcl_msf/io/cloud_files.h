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
 * \param camera of the cloud's sensor; when not given it is taken from the points
 * (estimateCamera) \throws IoError, also when the points tell no camera or are not an
 * image of the given one (fitsCamera) */
RgbdImages
readCloudImages (const std::string& path,
                 const std::optional<PinholeCamera>& camera = {});

} // namespace pcl_msf::io
