// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

// Values of what is told of a result.

/** \brief Which segments' motions are known. */
struct StatusTuning {
  double seen_enough{0.15}; ///< share of visible points that determines a motion
  double rank_share{1e-5};  ///< of the largest eigenvalue: less is a freedom
  double connected{0.5};    ///< lifting weight of a link that supports
};

/** \brief Points moved by several segments; see "Points move by blended motions" in
 * DECISIONS.md. */
struct BlendTuning {
  double least_strength{0.2}; ///< mixing of links that take part
  double reach{0.5};          ///< of a segment's side: standard deviation of its weight
};

/** \brief Is the surface between two segments soft? See "Soft where a mixture fits
 * better" in DECISIONS.md. */
struct SoftTuning {
  int samples{96};       ///< points per segment and link
  int least_samples{12}; ///< that lie between the centres
  float near{0.15f};     ///< shares of the way between the centres: nearer to either
  float far{0.85f};      ///< one, both motions agree
  double clear{0.1};     ///< mean cost per point that counts as a difference
};

/** \brief What a motion group is; see "Small soft bodies are one motion group" in
 * DECISIONS.md. */
struct GroupTuning {
  double together{0.95}; ///< lifting weight that joins bodies
  double soft{0.999};    ///< mixing that does
  int small_body{8};     ///< segments that a body of a soft surface has
};

/** \brief What is visible; see "Visible within the residuals' own tolerance" in
 * DECISIONS.md. */
struct VisibilityTuning {
  float most_widening{3.0f}; ///< of the z-test's tolerance
  float most_share{0.1f};    ///< of the inverse depth: more tells no surfaces apart
  int surface{4};            ///< measurements that make one
};

/** \brief When a result is worth nothing; see "Different places by local contrast" and
 * "One place is told by fine texture" in DECISIONS.md. */
struct OutcomeTuning {
  int few_points{20};          ///< three residuals per parameter of a pose
  double few{0.02};            ///< share of the moved points
  double hardly_any{0.15};     ///< share of those that land on depth
  double mostly{0.5};          ///< share of the points with depth
  double no_surface{0.1};      ///< noise as a share of the mean inverse depth
  double least_contrast{0.02}; ///< standard deviation of the intensity
  double significant{3.0};     ///< standard deviations of the noise: texture of a patch
  int patches{20};             ///< whose median tells something
  /** Median correlation of texture, the middle between what recordings show: of one
   * place 0.67 and more, also where most things move or are followed wrongly; of
   * different ones 0.26 and less. */
  double same_place{0.47};
  /** Where texture tells nothing. Of 117 pairs of one place, taken without colour, 75 %
   * or more of what lands on depth is found. Of 39 unrelated ones that pass every
   * other test, 36 find less: below few_found, or with 11 % of the rest in front. */
  double found{0.7};
  double in_front{0.06}; ///< of what is found or in front
  double few_found{0.3}; ///< share of those that land; the others may be hidden
  float near{0.03f};     ///< of the depth: one surface, roughly fitted
};

/** \brief How sure a pose is; see "Information by what a body's residuals share" and
 * "A segment may belong elsewhere" in DECISIONS.md. */
struct InformationTuning {
  double tiles{20.0};     ///< of an image, over which residuals are summed up
  int enough_tiles{8};    ///< of a body; else they are made smaller ...
  double least_tile{12};  ///< ... down to this side, pixels
  double pooled{8.0};     ///< tiles that all bodies together count as, beside its own
  double reach{30.0};     ///< pixels: deviation of a motion that nothing is known of
  double elsewhere{0.01}; ///< probability that a segment belongs to other bodies though
                          ///< its residuals object: they err alike, too
  double mean_objection{0.3}; ///< cost a residual by which they can object at most
  double not_found{0.5};      ///< probability of a wrong motion when nothing is seen
  double own{0.005}; ///< probability of a motion of its own, when residuals are content
};

/** \brief How sure a point's motion is, beside the pose. */
struct DeviationTuning {
  int near_step{2};           ///< pixels: where a sensor takes one side of a step
  int far_step{4};            ///< for the other
  double across{0.03};        ///< probability that it did
  double across_unseen{1.0};  ///< and where the point is not found where it lands
  double least_pixels{0.003}; ///< no flow is better
};

struct ResultTuning {
  StatusTuning status;
  BlendTuning blend;
  SoftTuning soft;
  GroupTuning groups;
  VisibilityTuning visibility;
  OutcomeTuning outcome;
  InformationTuning information;
  DeviationTuning deviation;
};

void
listValues (ResultTuning& tuning, TunedValues& values);

} // namespace pcl_msf
