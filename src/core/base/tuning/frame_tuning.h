// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

// Values of a frame's images. "Inverse depth" is in 1 / metres. Unless a struct says
// otherwise they were chosen on generated scenes of seeds 1 and 3.

/** \brief Normals by planes through the inverse depth around a pixel. */
struct NormalTuning {
  float same_surface{0.03f}; ///< of the inverse depth, per pixel of distance: beyond it
                             ///< a neighbour is another surface; more rounds edges,
                             ///< less leaves noisy normals
  float noise_sigmas{4.0f};  ///< or so many standard deviations of the noise: likewise
  float steepest{0.3f};      ///< of the inverse depth over the window, on a floor that
                             ///< is seen at a grazing angle: more is taken for surface
  double error{0.08}; ///< radians aimed at: less widens windows, which round edges
  int max_radius{4};  ///< pixels; even, as the step in wide windows is two; more rounds
                      ///< edges where depth is noisy, and is slower
};

/** \brief How the exposure changed between two frames; see "Exposure change by the
 * ratio of spreads" and "Under another light contrast is compared" in DECISIONS.md. */
struct BrightnessTuning {
  int min_pairs{100};      ///< of intensities, else no change is assumed
  double min_spread{0.02}; ///< intensity: less contrast tells no gain
  int rounds{5};           ///< of leaving out what does not fit; more is slower
  double inlier_mads{3.0}; ///< median misfits that fit: more lets wrong matches in
  int light_pairs{2000};   ///< of intensities that tell whether light changed; more is
                           ///< slower
  double term_prior{0.03}; ///< intensity: standard deviation of what light changes:
                           ///< more explains texture by light
  double light_explained{0.7}; ///< of the median misfit may stay once such changes are
                               ///< allowed for: then light changed; more finds such
                               ///< changes where there are none
  double least_light{
      0.001};             ///< intensity: and so much of it must go: likewise, less does
  int contrast_radius{4}; ///< pixels of a level: then its mean within is left out;
                          ///< more keeps more, of light as well
};

/** \brief Frames and their pyramids. */
struct FrameTuning {
  NormalTuning normals;
  BrightnessTuning brightness;
  float same_surface{0.02f}; ///< of the inverse depth: what a coarser level averages;
                             ///< more mixes surfaces, less keeps noise
  float same_sigmas{3.0f};   ///< or so many standard deviations of the noise: likewise
  int smallest_side{24};     ///< pixels of the coarsest level: less reaches farther,
                             ///< with less to tell
};

void
listValues (FrameTuning& tuning, TunedValues& values);

} // namespace pcl_msf
