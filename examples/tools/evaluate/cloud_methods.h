// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "cloud_cases.h"

#include <string>
#include <utility>
#include <vector>

namespace pcl_msf::tool {

/** \brief Where a method says that the source's points go. */
struct CloudEstimate {
  std::vector<Eigen::Vector3f> warped; ///< NaN = unknown
  bool converged{false};
  double seconds{0.0};
};

/** \brief Names of methods for clouds without a grid, with a line each. */
std::vector<std::pair<std::string, std::string>>
cloudMethodHelp ();

/** \throws InvalidInput when the method cannot take the clouds, Interrupted */
CloudEstimate
runCloudMethod (const std::string& method, const CloudCase& data, unsigned threads);

} // namespace pcl_msf::tool
