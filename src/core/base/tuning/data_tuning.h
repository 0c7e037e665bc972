// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

/** \brief What residuals that are not compared cost, as misfits of so many deviations:
 * hidden ones less than a wrong match and more than a right one. More drives segments
 * to where they are seen, less hides them; see "Hidden points cost, less beside a
 * visible neighbour" in DECISIONS.md. */
struct MissingTuning {
  double wrong_match{4.0}; ///< also the limit of a probe's residuals, and what a
                           ///< hidden one costs beside no visible neighbour
  double no_depth{3.0};    ///< where the other frame has none
  double occluded{2.5};    ///< behind what the other frame sees; no more than a wrong
                           ///< match, else segments would leave what hides them
  double out_of_view{2.0}; ///< beside the image
};

/** \brief What residuals are worth; see "Residuals count for what they are worth" in
 * DECISIONS.md. */
struct CorrelationTuning {
  int tile{16};        ///< pixels of level 0: more than sensors' windows
  int least_tiles{12}; ///< that a median is taken of; fewer keep what was measured
                       ///< before
  double least_filled{0.25}; ///< share of a tile: a body's part that counts; more
                             ///< leaves small bodies out
  int most_rows{15};         ///< of tiles that are looked at: more is slower
};

/** \brief The noise that rigid bodies show; see "Rigid bodies are weighed by their own
 * residuals" in DECISIONS.md. */
struct BodyNoiseTuning {
  int rigid{8};                ///< segments that make a rigid body: fewer would fit
                               ///< their own noise
  int samples{4000};           ///< points of a body; more is slower
  int least_samples{100};      ///< that a median is taken of; fewer change nothing
  double most_brightness{3.0}; ///< largest factor on the scale of Eq. 6: more holds
                               ///< bodies to their texture
  double most_icp{10.0};       ///< and of Eq. 8: likewise, to their depth
};

/** \brief Values of the data terms. */
struct DataTuning {
  int probes{64};                  ///< points of a segment that compare poses; more is
                                   ///< slower
  double relative_tolerance{0.01}; ///< of the inverse depth, in the z-test at level 0;
                                   ///< doubles per level: more sees hidden points, less
                                   ///< hides seen ones
  int finest_thinning{4};   ///< pixels of level 0 that a point of a solve stands for,
                            ///< 1, 2 or 4; more is faster and less precise where noise
                            ///< is white; see "Solves take a pattern of the pixels" in
                            ///< DECISIONS.md
  int half_thinning{2};     ///< likewise, of level 1
  int least_thinned{50000}; ///< pixels of a level that is thinned: in small images
                            ///< noise averages less
  MissingTuning missing;
  CorrelationTuning correlation;
  BodyNoiseTuning body_noise;
};

void
listValues (DataTuning& tuning, TunedValues& values);

} // namespace pcl_msf
