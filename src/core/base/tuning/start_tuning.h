// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

// Values of the start of two frames, chosen on generated scenes of seeds 1 and 3 unless
// a struct says otherwise. Costs are means per residual.

/** \brief Rigid motions fitted to optical flow. */
struct RigidFitTuning {
  double smallest_scale{0.5}; ///< pixels: residuals below are inliers; more lets wrong
                              ///< flow in
  int iterations{6};          ///< of reweighting; more is slower
  double rotation_prior{4.0}; ///< pixels per radian, per sample: holds noise down; more
                              ///< misses turns of small segments
  float depth_scale{3.0f};    ///< standard deviations: a larger error counts less; less
                              ///< leaves motion along the ray to flow alone
  float depth_weight{0.2f};   ///< pixels^2 per standard deviation^2: more trusts depth
                              ///< where flow lands beside an edge
  float depth_share{0.05f};   ///< likewise, where a sample chooses among motions
};

/** \brief Poses that segments try; see "Motions spread at the coarsest level" in
 * DECISIONS.md. */
struct ProposalTuning {
  double own_penalty{0.05};  ///< cost of a candidate that is the segment's own: more
                             ///< makes neighbours move alike
  double rough{0.2};         ///< of what links cost, as poses are rough yet: likewise
  double mostly_hidden{0.5}; ///< share of residuals: such a neighbour is no support:
                             ///< more lets hidden segments support each other
  double clearly_better{0.995}; ///< factor that a change must lower the cost by:
                                ///< less changes less
  int first_rounds{4};          ///< at the start; more is slower
  int later_rounds{2};          ///< likewise, between levels
};

/** \brief Hypotheses from optical flow. */
struct FlowTuning {
  double noise{2.0};          ///< factor on the frames' depth noise: more leaves
                              ///< motion along the ray to flow
  int min_samples{6};         ///< of a segment that has a fit: fewer fit noise
  int max_bodies{6};          ///< that many segments share; more is slower
  int voters{4};              ///< samples per segment in the search for bodies; more is
                              ///< slower
  double vote_limit{3.0};     ///< pixels: truncated there; more joins bodies
  double explained{0.7};      ///< of the limit: such a voter has its body: likewise
  double smallest_body{0.02}; ///< share of all voters: less finds smaller ones, more
                              ///< of them by chance
  int quarter_width{640};     ///< pixels: larger images are matched at a quarter of
                              ///< their size, which is faster
  int quarter_depth_width{320}; ///< likewise, of images of depth
  int quarter_height{128};      ///< and of both
};

/** \brief Optical flow as evidence beside the residuals; see "Optical flow is evidence"
 * in DECISIONS.md. */
struct FlowEvidenceTuning {
  int samples{9};    ///< of a segment; more is slower
  double sigma{1.0}; ///< pixels: of flow in rich texture; more gives it less weight
  double spread{
      1.5}; ///< standard deviation by what a segment's rigid fit leaves: likewise
  double cap{5.0};       ///< standard deviations: wrong flow weighs no more; more holds
                         ///< segments to it from farther away
  double solving{2.0};   ///< independent residuals that a segment's flow is worth, at
                         ///< coarse levels of the solve: more holds to wrong flow,
                         ///< less loses what jumped,
  double proposing{1.0}; ///< and at the start's jumps
};

/** \brief Matched features; see "Features where flow fails" in DECISIONS.md. */
struct FarMotionTuning {
  int features{1500};   ///< strongest ones of a frame; more is slower
  float distinct{0.8f}; ///< distance of the best match by that of the second: more lets
                        ///< wrong matches in
  int group{6}; ///< matches of a fit: a match and those nearest to it; more misses
                ///< small bodies, fewer fit noise
  int most_groups{400}; ///< more is slower
  int min_matches{15};  ///< of a motion: fewer agree by chance
  int enough{60};       ///< matches that may contradict the flow: more keeps wrong flow
  int most_motions{8};  ///< more is slower
  double agree{3.0};    ///< pixels: more joins bodies
  double explained{0.7}; ///< of that: such a match has its motion; likewise
};

struct StartTuning {
  RigidFitTuning fit;
  ProposalTuning proposals;
  FlowTuning flow;
  FlowEvidenceTuning evidence;
  FarMotionTuning far_motion;
  double unexplained{0.4}; ///< cost after the first start: the depth's flow is tried;
                           ///< less is slower
  double lost{0.7}; ///< share of segments then: features are matched; less is slower
  double same_depth{0.05}; ///< relative: pixels that compare the exposure anew; more
                           ///< lets wrong ones in
};

void
listValues (StartTuning& tuning, TunedValues& values);

} // namespace pcl_msf
