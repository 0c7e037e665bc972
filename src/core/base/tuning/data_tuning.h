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
  double wrong_match{4.0}; ///< also the limit of a probe's residuals
  double no_depth{3.0};
  double occluded{2.5};
  double out_of_view{2.0};
};

/** \brief What residuals are worth; see "Residuals count for what they are worth" in
 * DECISIONS.md. */
struct CorrelationTuning {
  int tile{16};        ///< pixels of level 0: more than sensors' windows
  int least_tile{2};   ///< pixels of the level
  int least_tiles{12}; ///< that a median is taken of
  int most_rows{15};   ///< of tiles that are looked at: more is slower
};

/** \brief The noise that rigid bodies show; see "Rigid bodies are weighed by their own
 * residuals" in DECISIONS.md. */
struct BodyNoiseTuning {
  int rigid{8};                ///< segments that make a rigid body
  int samples{4000};           ///< points of a body
  int least_samples{100};      ///< that a median is taken of
  double most_brightness{3.0}; ///< largest factors on the scales
  double most_icp{10.0};
};

/** \brief Values of the data terms. */
struct DataTuning {
  int probes{64};                  ///< points of a segment that compare poses
  double relative_tolerance{0.01}; ///< of the inverse depth, in the z-test at level 0;
                                   ///< doubles per level
  MissingTuning missing;
  CorrelationTuning correlation;
  BodyNoiseTuning body_noise;
};

void
listValues (DataTuning& tuning, TunedValues& values);

} // namespace pcl_msf
