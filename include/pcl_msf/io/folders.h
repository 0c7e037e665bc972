// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <string>

namespace pcl_msf::io {

/** \brief Makes a folder and those above it, unless it is there. \throws IoError */
PCL_MSF_EXPORT void
makeFolder (const std::string& path);

} // namespace pcl_msf::io
