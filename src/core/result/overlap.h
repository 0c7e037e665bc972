// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/result_tuning.h"
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/scene_flow.h>

namespace pcl_msf {

/** \brief How much of the reference another frame shows, counted in points. */
struct Overlap {
  int points{0}; ///< with depth
  int moved{0};  ///< of those, whose motion is known
  int landed{0}; ///< of those, in view and where the frame has depth
  int found{0};  ///< of those, visible
};

/** \brief Counts. \param flow with flow and visibility */
Overlap
measureOverlap (const RgbdFrame& current, const SceneFlow& flow, int threads);

/** \brief Counts the points that would stand before what the other frame measures where
 * they land: it could not have seen that through them. Points behind it may be hidden.
 * \param flow with flow, points and displacement */
int
countInFront (const RgbdFrame& reference,
              const RgbdFrame& current,
              const OutcomeTuning& tuning,
              const SceneFlow& flow);

/** \brief How alike the texture of visible points is in both frames. */
struct Likeness {
  int patches{0};     ///< small squares whose texture stands out of the noise
  double median{0.0}; ///< of their normalized cross-correlations; 1: the same but for
                      ///< gain and offset, 0: nothing in common
};

/** \brief Compares the reference's patches with what is found where they move to.
 *
 * Outlines and shades of a patch's own size say little: what stands before something
 * darker in both frames looks alike in unrelated ones, too. Fine texture does not agree
 * by chance, and the median over all patches is not moved by things that went away, or
 * whose motion is wrong, as long as most of the texture is followed.
 * \param flow with flow and visibility
 * \param intensity_noise standard deviation
 * \return no patches without intensity */
Likeness
compareTexture (const RgbdFrame& reference,
                const RgbdFrame& current,
                double intensity_noise,
                const OutcomeTuning& tuning,
                int threads,
                const SceneFlow& flow);

} // namespace pcl_msf
