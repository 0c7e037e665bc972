// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <string>

namespace pcl_msf::io {

/** \brief Makes a folder and those above it, unless it is there. \throws IoError */
void
makeFolder (const std::string& path);

} // namespace pcl_msf::io
