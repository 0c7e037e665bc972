// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/synthetic/sequence_options.h>

#include <cstdint>

namespace pcl_msf::synthetic {

/** \brief What a sensor's colour camera does to an image: CV_32FC3, 0 .. 255, changed
 * in place: vignette, the frame's exposure, and noise of 2.5 / 255, which is smooth
 * over neighbouring pixels where a sensor makes three colours of one (all but White).
 * \param frame tells frames and seeds apart */
void
applyColorCamera (Sensor sensor,
                  const CameraEffects& effects,
                  std::uint64_t frame,
                  int threads,
                  cv::Mat& color);

} // namespace pcl_msf::synthetic
