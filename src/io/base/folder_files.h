// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief Order of names in which runs of digits count by their value: a2 < a10. */
PCL_MSF_EXPORT bool
naturalLess (const std::string& a, const std::string& b);

/** \brief Paths of the files in a folder whose lower-case extension is among those
 * given, in natural order; none when there is no such folder. */
PCL_MSF_EXPORT std::vector<std::string>
filesIn (const std::string& folder, const std::vector<std::string>& extensions);

} // namespace pcl_msf::io
