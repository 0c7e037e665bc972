// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include <pcl_msf/multiframe_scene_flow.h>
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

/** \brief Those for more than two frames. */
struct WindowSettings : MethodSettings {
  int window{0};     ///< frames solved jointly; 0 = a number that the tool chooses
  bool rigid{false}; ///< the whole scene is one rigid body
  MultiframeParameters multiframe;
};

/** \brief Adds --rigid and the multiframe parameters, as addMethodOptions does. */
void
addMultiframeOptions (CLI::App& app, WindowSettings& settings);

/** \brief Checks all parameters once `app` has read them, and lets --rigid choose the
 * segmentation. \throws UsageError naming the option */
void
checkSettings (const CLI::App& app, WindowSettings& settings);

/** \brief Lets OpenCV have no more threads than the settings allow. */
void
limitThreads (const MethodSettings& settings);

} // namespace pcl_msf::tool
