// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_constraints.h>

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief A label a line, as parts.txt has them. \throws IoError */
std::vector<int>
readLabels (const std::string& path);

/** \brief "source target", indices, "source target weight" or "source target weight k",
 * of the k-th target from 1, a line; what follows a # is a remark. \throws IoError */
std::vector<KnownPair>
readPairs (const std::string& path);

} // namespace pcl_msf::tool
