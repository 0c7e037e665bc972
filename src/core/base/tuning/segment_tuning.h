// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

// Values of the oversegmentation, its links and its points. A "tolerance" is the
// standard deviation by which a pixel may lie off its surface: the noise, and
// plane_share. Chosen on generated scenes of seeds 1 and 3; see "Plane clusters as the
// default segments" in DECISIONS.md.

/** \brief Clusters of pixels on one plane. */
struct ClusterTuning {
  int iterations{4}; ///< at every second pixel, before the full one; more is slower
  float intensity_scale{8.0f}; ///< one over the difference that counts as one side of a
                               ///< cluster: more follows texture, less ignores it
  float plane_scale{0.25f};    ///< one over the tolerances off the plane that do: more
                               ///< cuts along edges, less makes compact clusters
  float plane_limit{9.0f}; ///< of the squared plane distance: more cuts small things
                           ///< out, less leaves them to their surroundings
  float outlier{8.0f}; ///< tolerances: farther does not move the plane; more tilts it
};

/** \brief What is one surface. */
struct ConnectionTuning {
  float stop{6.0f}; ///< tolerances off the tangent plane that end a surface: more joins
                    ///< surfaces, less cuts noisy ones
  int rounds{3};    ///< of giving small parts away: some lie in the middle of others;
                    ///< more is slower
};

/** \brief How strong links are; see "Links have a strength, by surface" in
 * DECISIONS.md.
 */
struct LinkTuning {
  float step{6.0f};   ///< tolerances between two pixels that end a surface: likewise
  double apart{0.03}; ///< strength of segments that share no surface: more drags walls
                      ///< along, less lets hidden segments drift
};

/** \brief A level's points. */
struct PixelTuning {
  int least_points{64};      ///< that thinning leaves of a segment; more is slower
  int least_samples{2048};   ///< of all segments together, see "Samples have a least
                             ///< number in all" in DECISIONS.md; more is slower
  float hidden_sigmas{5.0f}; ///< standard deviations of the inverse depth's noise
                             ///< within which a point is visible: more sees hidden ones
};

struct SegmentTuning {
  float plane_share{
      0.002f}; ///< of the inverse depth, beside the noise: what is not plane: more
               ///< bends segments over edges, less cuts curved surfaces up
  ClusterTuning clusters;
  ConnectionTuning connections;
  LinkTuning links;
  PixelTuning pixels;
};

void
listValues (SegmentTuning& tuning, TunedValues& values);

} // namespace pcl_msf
