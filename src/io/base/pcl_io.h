// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <pcl_msf/export.h>

#include <string>
#include <vector>

// The functions of libpcl_io that are used. It is loaded by their first call: it and
// VTK's libraries, which it brings along, are half of those of a tool, and take 0.1 s.
namespace pcl_msf::io {

/** \brief Reads a file whose name says of which kind it is. \return whether PCL could;
 * it prints why not */
PCL_MSF_EXPORT bool
readByPcl (const std::string& path, pcl::PCLPointCloud2& cloud);

/** \brief Unpacks what LZF has packed. \return whether it filled `to` */
PCL_MSF_EXPORT bool
unpackByPcl (const std::vector<char>& from, std::vector<char>& to);

} // namespace pcl_msf::io
