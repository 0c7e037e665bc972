// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

// Values of what is told of a result. Unless a struct says otherwise they were chosen
// on generated scenes of seeds 1 and 3.

/** \brief Which segments' motions are known. */
struct StatusTuning {
  double seen_enough{0.15}; ///< share of visible points that determines a motion: more
                            ///< calls fewer motions determined
  double rank_share{1e-5};  ///< of the largest eigenvalue: less is a freedom;
                            ///< likewise
  double connected{0.5};    ///< lifting weight of a link that supports: likewise
};

/** \brief Points moved by several segments; see "Points move by blended motions" in
 * DECISIONS.md. */
struct BlendTuning {
  double least_strength{0.2}; ///< mixing of links that take part: more tears soft
                              ///< surfaces, less bends rigid ones
  double reach{0.5}; ///< of a segment's side: standard deviation of its weight;
                     ///< more is smoother
};

/** \brief How the images adapt the flow of points that move otherwise than most; see
 * "Images have a say where bodies are small" in DECISIONS.md. Weights are those of
 * OpenCV's refinement, for 8-bit images. */
struct RefinementTuning {
  double common{0.3}; ///< share of the points from which on the dominant body is rigid
                      ///< without doubt and keeps its motion: more adapts static scenes
  int tile{96};       ///< pixels, side of what is adapted at a time: more keeps more
                      ///< processors waiting, less adapts margins again and again
  int margin{6};      ///< pixels around a tile: less shows seams
  int most_spread{8}; ///< pixels, how far a tile's motions may differ to be all in the
                      ///< images that it works on: more is slower
  double better{0.8}; ///< of the motion's residual: below it optical flow takes over;
                      ///< more takes its errors
  double window{2.0}; ///< pixels, standard deviation: residuals are averaged over it;
                      ///< more blurs edges of motions
  double most_residual{0.2}; ///< that counts: more lets single pixels rule
  double clearly{0.95};      ///< of a segment's residuals with the noise: above it the
                        ///< motion stays as it was; more adapts rigid bodies to chance
  double smoothness{20.0}; ///< more follows the images less
  double brightness{5.0};  ///< more follows them closer
  double gradient{10.0};   ///< likewise, whatever the light
  int iterations{2};       ///< of the nonlinear problem: more is slower
  int relaxations{5};      ///< of each linear one: likewise
};

/** \brief Is the surface between two segments soft? See "Soft where a mixture fits
 * better" in DECISIONS.md. */
struct SoftTuning {
  int samples{96};       ///< points per segment and link; more is slower
  int least_samples{12}; ///< that lie between the centres; fewer decide nothing
  float near{0.15f};     ///< shares of the way between the centres: nearer to either
  float far{0.85f};      ///< one, both motions agree
  double clear{0.1};     ///< mean cost per point that counts as a difference: less
                         ///< takes noise for one
};

/** \brief What a motion group is; see "Small soft bodies are one motion group" in
 * DECISIONS.md. */
struct GroupTuning {
  double together{0.95}; ///< lifting weight that joins bodies: more splits groups
  double soft{0.999};    ///< mixing that does: likewise
  int small_body{8}; ///< segments that a body of a soft surface has at the most: more
                     ///< joins rigid ones
};

/** \brief What is visible; see "Visible within the residuals' own tolerance" in
 * DECISIONS.md. */
struct VisibilityTuning {
  float most_widening{3.0f}; ///< of the z-test's tolerance: more calls hidden
                             ///< points visible, less the other way round
  float most_share{0.1f};    ///< of the inverse depth: more tells no surfaces apart
  int surface{4};            ///< measurements that make one: more loses thin parts
  int samples{20000}; ///< points that the widening is measured on; more is slower
};

/** \brief When a result is worth nothing; see "Different places by local contrast" and
 * "One place is told by fine texture" in DECISIONS.md. */
struct OutcomeTuning {
  // More of these calls more results worthless; less lets wrong ones pass.
  int few_points{20};          ///< found: three residuals per parameter of a pose
  double few{0.02};            ///< found, share of the moved points
  double hardly_any{0.15};     ///< found, share of those that land on depth
  double mostly{0.5};          ///< found or moved, share of the points with depth
  double no_surface{0.1};      ///< noise as a share of the mean inverse depth: above
                               ///< it there is none
  double least_contrast{0.02}; ///< standard deviation of the intensity: blank below
  double significant{3.0};     ///< standard deviations of the noise: texture of a patch
  int patch{9};                ///< pixels, side: more sees outlines, less only noise
  int patch_seen{60};          ///< pixels of a patch that are seen in both frames
  int patches{20};             ///< whose median tells something
  /** Median correlation of texture, the middle between what recordings show: of one
   * place 0.67 and more, also where most things move or are followed wrongly; of
   * different ones 0.26 and less. */
  double same_place{0.47};
  /** Where texture tells nothing. Of 117 pairs of one place, taken without colour, 75 %
   * or more of what lands on depth is found. Of 39 unrelated ones that pass every
   * other test, 36 find less: below few_found, or with 11 % of the rest in front. */
  double found{0.7};
  double in_front{0.06}; ///< of what is found or in front: so much contradicts
  double few_found{0.3}; ///< share of those that land; the others may be hidden
  float near{0.03f};     ///< of the depth: one surface, roughly fitted; more lets
                         ///< points stand in front
};

/** \brief How sure a pose is; see "Information by what a body's residuals share" and
 * "A segment may belong elsewhere" in DECISIONS.md. */
struct InformationTuning {
  double tiles{20.0};     ///< of an image, over which residuals are summed up: more
                          ///< misses errors that large parts share
  int enough_tiles{8};    ///< of a body; else they are made smaller ...
  double least_tile{12};  ///< ... down to this side, pixels ...
  double smaller{1.5};    ///< ... by this factor at a time
  double pooled{8.0};     ///< tiles that all bodies together count as, beside its own:
                          ///< more makes all equally sure
  double reach{30.0};     ///< pixels: deviation of a motion that nothing is known of;
                          ///< more makes what is hidden less sure
  double elsewhere{0.01}; ///< probability that a segment belongs to other bodies
                          ///< against its residuals, which err alike, too: more makes
                          ///< all segments less sure
  double most_extra{0.3}; ///< extra cost a residual with another body's pose that
                          ///< counts at the most: more rules other bodies out
  double not_found{0.5};  ///< probability of a wrong motion when nothing is seen: more
                          ///< makes what is hidden less sure
  double own{0.005}; ///< probability of a motion of its own, when residuals fit: more
                     ///< makes all segments less sure
};

/** \brief How sure a point's motion is, beside the pose; more of any value is less
 * sure. See "A segment may belong elsewhere" in DECISIONS.md. */
struct DeviationTuning {
  int near_step{2};           ///< pixels: where a sensor takes one side of a step
  int far_step{4};            ///< for the other ...
  float far_weight{0.5f};     ///< ... which is so likely
  double across{0.03};        ///< probability that it did
  double across_unseen{1.0};  ///< and where the point is not found where it lands
  double least_pixels{0.003}; ///< standard deviation: no flow is better
};

struct ResultTuning {
  StatusTuning status;
  BlendTuning blend;
  RefinementTuning refinement;
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
