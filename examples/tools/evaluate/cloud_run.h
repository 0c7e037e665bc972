// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "cloud_methods.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Errors of an answer: distances of warped points to where they lie in truth,
 * over points with truth; in the clouds' unit. A point that is unknown counts as one
 * that did not move. */
struct CloudScore {
  double mean;
  double median;
  double p95;
  double within; ///< share below 10 mm, were the unit a metre
  int points;    ///< with truth
};

/** \brief All NaN when no point has truth. */
CloudScore
scoreClouds (const CloudCase& data, const std::vector<Eigen::Vector3f>& warped);

/** \brief Scores the methods on the shard's cases and prints a table; CSV and JSON as
 * the options say. \return exit status: 1 when something failed, which stderr names
 * \throws UsageError, IoError, Interrupted */
int
evaluateClouds (const EvaluateOptions& options);

/** \brief Joins the CSVs of shards as the options say. \return exit status: 1 when
 * cases are missing, which stderr tells \throws UsageError, IoError */
int
mergeCloudShards (const EvaluateOptions& options);

} // namespace pcl_msf::tool
