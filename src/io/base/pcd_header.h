// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/io/rgbd_images.h>

#include <string>

namespace pcl_msf::io {

/** \brief What a .pcd file has to hold. */
enum class PcdShape {
  Image, ///< width x height points of a camera, two rows or more
  Points ///< points in any number of rows
};

/** \brief What of a .pcd file's header its reader does not tell. */
struct PcdHead {
  int begin{0};        ///< bytes before it: those of a byte order mark
  Viewpoint viewpoint; ///< where the header has none: no rotation, no translation
};

/** \brief Checks a .pcd file's header against the size of the file, because PCL's
 * reader allocates what the header says. \throws IoError */
PCL_MSF_EXPORT PcdHead
checkPcdHeader (const std::string& path, PcdShape shape);

} // namespace pcl_msf::io
