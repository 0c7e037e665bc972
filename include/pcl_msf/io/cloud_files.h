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
 * Fields x y z are required (camera frame, NaN = no point). Colour is, in this order:
 * rgb or rgba as PCL packs them or of three numbers; r g b; red green blue; intensity
 * (or intensities, gray, grey). Bytes are 0 .. 255; other numbers are brought to that
 * range by normalizeIntensity, from the values of this cloud. Other fields are ignored.
 * With colour every point's alpha is 255, without any it is 0.
 * \throws IoError for anything else, unorganized clouds included */
pcl::PointCloud<pcl::PointXYZRGBA>::Ptr
readOrganizedCloud (const std::string& path);

/** \brief Reads an organized cloud as images, see readOrganizedCloud; `note` says when
 * there is no colour.
 *
 * \param camera of the cloud's sensor; when not given it is taken from the points
 * (estimateCamera) \param units_per_metre of x y z, > 0, e.g. 1000 for millimetres
 * \throws IoError, also when the points tell no camera or are not an image of the given
 * one (fitsCamera) */
RgbdImages
readCloudImages (const std::string& path,
                 const std::optional<PinholeCamera>& camera = {},
                 double units_per_metre = 1.0);

} // namespace pcl_msf::io
