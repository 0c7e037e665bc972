// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/point_files.h>

#include <string>

namespace pcl_msf::io {

/** \brief The vertices of a .ply file, ascii or binary of either byte order.
 * \throws IoError */
PointFile
readPly (const std::string& path);

} // namespace pcl_msf::io
