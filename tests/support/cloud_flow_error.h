// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_flow.h>

#include <limits>
#include <vector>

namespace pcl_msf::testing {

/** \brief Mean distance, metres, of the points whose place is known from where they
 * truly are; infinite without any. */
inline double
meanError (const CloudFlow& flow, const std::vector<Eigen::Vector3f>& truth)
{
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    if (flow.warped[i].allFinite() && truth[i].allFinite()) {
      sum += (flow.warped[i] - truth[i]).norm();
      ++count;
    }
  return count > 0 ? sum / count : std::numeric_limits<double>::infinity();
}

} // namespace pcl_msf::testing
