// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

// Values of the steps that form bodies. Costs are means per residual, a wrong match
// costs some two.

/** \brief How unequal two bodies' motions may be and still count as one: more makes
 * fewer and larger bodies; see "Residuals count for what they are worth" in
 * DECISIONS.md. */
struct MergeTuning {
  double allowance{10.0}; ///< increase allowed per merge, in halved squared deviations
  double per_point{
      0.08};      ///< further increase per independent point of the smaller body
  int largest{6}; ///< bodies that every other one may join: more is slower
};

/** \brief Which segments land on one place; see "One place has one origin" in
 * DECISIONS.md. */
struct LandingTuning {
  int cell{3};          ///< pixels: more has neighbours collide, less misses
                        ///< collisions of sparse points
  int per_segment{128}; ///< points of a segment that count; more is slower
  /** Standard deviations of the intensity within which a point looks like what it
   * lands on: more counts landings by chance, less misses true ones. */
  float looks_alike{2.5f};
  double worse{1.0}; ///< mean cost per residual, more by which one does not own a
                     ///< place: more drives out what fits, less leaves two on a place
};

/** \brief How segments are assigned to bodies; see "Leaving the largest body costs
 * odds" in DECISIONS.md. */
struct AssignmentTuning {
  double separation{0.25};       ///< cost of leaving all neighbours: more drags small
                                 ///< parts along, less leaves speckles
  double window_separation{0.2}; ///< the same in a window of more frames
  double prior{25.0};     ///< natural logarithm of the odds that a segment belongs to
                          ///< the largest body: what leaving it costs all of its
                          ///< independent residuals together: more holds what
                          ///< moves little, less lets noise leave ...
  double most_prior{0.5}; ///< ... and at the most the mean of them
  double flow_worth{0.3}; ///< residuals that optical flow of a segment is worth:
                          ///< little, as it errs over whole regions
  int rounds{3};          ///< of assigning all; more is slower
  int largest{6};         ///< bodies that every segment tries ...
  double least_share{0.0125}; ///< ... of so many of the segments: a single one fits
                              ///< other places by chance
  double mostly_hidden{0.5};  ///< share of residuals: such a neighbour is no support:
                              ///< more lets hidden segments support each other
  double border_share{0.5};   ///< of points that may land on a neighbour's place: more
                              ///< lets bodies overlap, less costs at borders
  LandingTuning landings;
};

/** \brief Hidden segments, which join a neighbour's body: more do, and lose motions of
 * their own, when either value is larger. */
struct HiddenTuning {
  double hidden{0.15}; ///< share of visible points: less makes a segment hidden
  double seen{0.5};    ///< likewise: so much makes a neighbour a candidate
};

struct BodyTuning {
  MergeTuning merging;
  AssignmentTuning assignment;
  HiddenTuning hidden;
};

void
listValues (BodyTuning& tuning, TunedValues& values);

} // namespace pcl_msf
