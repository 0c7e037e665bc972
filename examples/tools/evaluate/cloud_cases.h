// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include "options.h"

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Words in place of a data set: bodies that are generated, and folders of
 * clouds without a grid. */
constexpr const char* kBodies = "bodies";
constexpr const char* kClouds = "clouds";

inline bool
isOfClouds (const EvaluateOptions& options)
{
  return options.dataset == kBodies || options.dataset == kClouds;
}

/** \brief Two clouds without a grid, and where each point of the source lies in the
 * target's frame; NaN = unknown. */
struct CloudCase {
  std::vector<Eigen::Vector3f> source;
  std::vector<Eigen::Vector3f> target;
  std::vector<Eigen::Vector3f> truth;
};

/** \brief What there is to score, in order: folders with source.ply, target.ply and
 * truth.ply, the path itself or below it, or names of generated bodies.
 * \throws UsageError when there is nothing */
std::vector<std::string>
listCloudCases (const EvaluateOptions& options);

/** \throws IoError naming the file */
CloudCase
loadCloudCase (const EvaluateOptions& options, const std::string& name);

} // namespace pcl_msf::tool
