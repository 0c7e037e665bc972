// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/frame_tuning.h"

#include <vector>

namespace pcl_msf {

/** \brief How the camera's exposure changed: I_current = gain I_reference + offset. */
struct BrightnessChange {
  float gain{1.0f};
  float offset{0.0f};
};

/** \brief Robust fit to pairs of intensities that show the same point.
 *
 * The line through the centre of the inliers with the ratio of their spreads as slope:
 * wrong pairs do not pull it towards zero as they would a regression line. The identity
 * when there are too few pairs or hardly any contrast. */
BrightnessChange
fitBrightnessChange (const std::vector<float>& reference,
                     const std::vector<float>& current,
                     const BrightnessTuning& tuning);

} // namespace pcl_msf
