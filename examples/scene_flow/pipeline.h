// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "options.h"
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/scene_flow.h>

namespace pcl_msf::tool {

/** \brief What the output is made of. */
struct Outcome {
  SceneFlow scene_flow;
  cv::Mat reference_color; ///< as loaded; empty without colour
  cv::Mat current_color;   ///< as loaded; empty without colour
  cv::Mat reference_depth; ///< CV_32FC1, metres
  cv::Mat current_depth;   ///< CV_32FC1, metres
  io::RunSeconds seconds;
};

/** \brief From files to the result.
 * \throws IoError, InvalidInput, UsageError, Interrupted */
Outcome
runPipeline (const Options& options);

} // namespace pcl_msf::tool
