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
  bool local{false}; ///< light changed, too: only local contrasts are comparable, by
                     ///< the gain alone; the offset is 0
};

/** \brief Intensities of points that two frames show. */
struct MatchedIntensities {
  std::vector<float> reference, current;
  std::vector<float> x, y; ///< where the reference shows them: -1 to 1 over its width
                           ///< and height
  /** Where both do: squared distances from the principal point over the focal length;
   * for fitFalloff (). */
  std::vector<float> reference_radius2, current_radius2;
};

/** \brief Gain and offset, a robust fit to pairs of intensities that show the same
 * point.
 *
 * The line through the centre of the inliers with the ratio of their spreads as slope:
 * wrong pairs do not pull it towards zero as they would a regression line. The identity
 * when there are too few pairs or hardly any contrast. */
BrightnessChange
fitExposureChange (const std::vector<float>& reference,
                   const std::vector<float>& current,
                   const BrightnessTuning& tuning);

/** \brief The same, and whether light changed. */
BrightnessChange
fitBrightnessChange (const MatchedIntensities& matches, const BrightnessTuning& tuning);

} // namespace pcl_msf
