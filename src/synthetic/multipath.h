// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <synthetic/sensor_model.h>

namespace pcl_msf::synthetic {

/** \brief How much too far a time-of-flight camera measures because of light that comes
 * by way of one other surface: CV_32FC1, metres along the ray.
 *
 * Diffuse surfaces, a light beside the camera; form factors of patches of 8 pixels, up
 * to 80 pixels apart. The error is the mean of the paths' excess lengths, weighted by
 * their light. */
cv::Mat
multipathError (const SensorInput& input);

} // namespace pcl_msf::synthetic
