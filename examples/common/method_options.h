// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include <pcl_msf/parameters.h>

namespace pcl_msf::tool {

/** \brief The method's parameters for two frames. */
struct MethodSettings {
  FrameParameters frame;
  SegmentationParameters segmentation;
  EnergyParameters energy;
  SolverParameters solver;
};

/** \brief Adds their options, bound to the fields of `settings`, which must outlive the
 * application. */
void
addMethodOptions (CLI::App& app, MethodSettings& settings);

} // namespace pcl_msf::tool
