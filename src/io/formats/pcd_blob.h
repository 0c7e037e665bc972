// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "io/base/pcd_header.h"
#include <pcl_msf/io/rgbd_images.h>

#include <string>

namespace pcl_msf::io {

/** \brief Reads a .pcd file by PCL, whose reader crashes on damaged headers
 * and takes the decimal comma of the locale.
 * \param[out] viewpoint when not null: the file's VIEWPOINT \throws IoError */
pcl::PCLPointCloud2
readPcd (const std::string& path,
         Viewpoint* viewpoint = nullptr,
         PcdShape shape = PcdShape::Image);

} // namespace pcl_msf::io
