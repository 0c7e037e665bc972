// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include "options.h"
#include <pcl_msf/io/rgbd_images.h>

namespace pcl_msf::tool {

/** \brief The two frames as files hold them, and labels when given. */
struct Inputs {
  io::RgbdImages reference;
  io::RgbdImages current;
  cv::Mat labels; ///< CV_32SC1; empty when a segmentation is to make them
};

/** \brief Reads all input files, the two frames in parallel.
 * \throws IoError, UsageError when sizes differ */
Inputs
loadInputs (const Options& options);

} // namespace pcl_msf::tool
