// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/cloud_flow.h>
#include <pcl_msf/io/point_files.h>

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief A registration of one target or several, as it is written. */
struct RegisterResults {
  io::PointFile source;
  std::vector<CloudFlow> flows; ///< per target
  double load_seconds{0.0};
  double total_seconds{0.0};

  /** \brief That speaks for all: the first one that was not found, else the last. */
  const CloudFlow&
  verdict () const;
};

/** \brief Is a file of that name a result? Of one target: warped.ply, registered.pcd,
 * parts.txt, joints.json, report.json. Of the K-th of several: these with _0_K, as
 * windows of frames; parts, the same in all, are parts_0.txt, and report.json is the
 * verdict's. */
bool
isResultName (const std::string& name);

/** \throws IoError */
void
writeResults (const RegisterResults& results, const std::string& folder);

/** \brief What was found, on stdout. */
void
printSummary (const RegisterResults& results, const std::string& folder);

} // namespace pcl_msf::tool
