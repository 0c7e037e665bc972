// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

// Values of a frame's images. "Inverse depth" is in 1 / metres.

/** \brief Normals by planes through the inverse depth around a pixel. */
struct NormalTuning {
  float same_surface{0.03f}; ///< of the inverse depth, per pixel of distance: beyond it
                             ///< a neighbour is another surface
  float noise_sigmas{4.0f};  ///< or so many standard deviations of the noise
  float steepest{0.3f};      ///< of the inverse depth over the window, on a floor that
                             ///< is seen at a grazing angle
  double error{0.08}; ///< radians aimed at: less widens windows, which round edges
  int max_radius{4};  ///< pixels; even, as the step in wide windows is two
};

/** \brief How the exposure changed between two frames. */
struct BrightnessTuning {
  int min_pairs{100};          ///< of intensities, else no change is assumed
  double min_spread{0.02};     ///< intensity: less contrast tells no gain
  int rounds{5};               ///< of leaving out what does not fit
  double inlier_mads{3.0};     ///< median misfits that fit
  double term_prior{0.03};     ///< intensity: standard deviation of what light changes
  double light_explained{0.7}; ///< of the median misfit may stay once such changes are
                               ///< allowed for: then light changed
  double least_light{0.001};   ///< intensity: and so much of it must go
  int contrast_radius{4};      ///< pixels of a level: then its mean within is left out;
                               ///< more keeps more, of light as well
};

/** \brief Frames and their pyramids. */
struct FrameTuning {
  NormalTuning normals;
  BrightnessTuning brightness;
  float same_surface{0.02f}; ///< of the inverse depth: what a coarser level averages
  float same_sigmas{3.0f};   ///< or so many standard deviations of the noise
  int smallest_side{24};     ///< pixels of the coarsest level
};

void
listValues (FrameTuning& tuning, TunedValues& values);

} // namespace pcl_msf
