// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "common/recordings.h"
#include "render/options.h"
#include <pcl_msf/visualization/result_scenes.h>

#include <vector>

namespace pcl_msf::tool {

/** \brief What there is to show. */
struct RenderInputs {
  visualization::ResultClouds result;
  std::vector<cv::Mat> displacements; ///< frame 1, 2, ... of the window, CV_32FC3
  bool converged{true};               ///< as far as the scene flow was computed here
};

/** \brief Reads a result folder, or estimates the scene flow of a folder with frames;
 * what is uncertain there becomes a line on stderr.
 * \throws IoError, InvalidInput, UsageError, Interrupted */
RenderInputs
loadRenderInputs (const RenderOptions& options);

} // namespace pcl_msf::tool
