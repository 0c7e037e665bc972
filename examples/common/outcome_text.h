// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/scene_flow.h>

#include <string>

namespace pcl_msf::tool {

/** \brief Why a result is not one to rely on; empty when it has converged. */
inline std::string
problemOf (const Report& report)
{
  if (report.converged)
    return {};
  return std::string ("not converged (") + toString (report.stop_reason) + ")" +
         (report.message.empty() ? "" : " ") + report.message;
}

} // namespace pcl_msf::tool
