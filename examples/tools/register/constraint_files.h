// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_constraints.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief A label a line, as parts.txt has them. \param points of the source
 * \throws IoError naming the line, also for another number of labels */
std::vector<int>
readLabels (const std::string& path, std::size_t points);

/** \brief "source target", indices, "source target weight" or "source target weight k",
 * of the k-th target from 1, a line; what follows a # is a remark. \param source its
 * number of points \param targets those of each \throws IoError naming the line, also
 * for what there is none of */
std::vector<KnownPair>
readPairs (const std::string& path,
           std::size_t source,
           const std::vector<std::size_t>& targets);

} // namespace pcl_msf::tool
