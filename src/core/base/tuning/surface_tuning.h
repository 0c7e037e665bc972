// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

namespace pcl_msf {

/** \brief What the points of a surface are told by. Chosen on pairs of clouds of bodies
 * with exact correspondences; see "Far limbs by geodesic anchors" in DECISIONS.md. */
struct SurfaceTuning {
  int neighbors{12};      ///< of a point, for normal and graph; more smooth thin parts
  int near{4};            ///< of these, the one whose distance is the spacing: more
                          ///< evens out doubled points
  float reach{4.0f};      ///< longest edge, spacings of its ends; more bridge gaps
  float facing{-0.35f};   ///< least cosine between the normals of an edge's ends: less
                          ///< joins the two sides of thin parts
  float steep{0.9f};      ///< largest sine between an edge and its ends' planes: more
                          ///< joins parts that touch, less cuts sharp edges
  float leap{0.8f};       ///< cosine between a step and both normals from which on it
                          ///< hands on no side: more turns through gaps, less leaves
                          ///< pieces turned wrongly
  float border_gap{2.2f}; ///< radians around a point without neighbours: a border; less
                          ///< takes sparse points for one
  int small_piece{12};    ///< points; smaller pieces are joined to the nearest one
  float dust_far{5.0f};   ///< median spacings from all others: no surface; more keeps
                          ///< stray points, less cuts sparse parts
  float dust_loose{2.2f}; ///< median spacings: none unless its neighbours lie flat;
                          ///< likewise
  float dust_flat{0.35f}; ///< own spacings across the neighbours' plane that are flat:
                          ///< likewise
  int bridge_neighbors{30}; ///< of a point, that may be of another given segment
  float bridge_reach{4.0f}; ///< median spacings between two segments that touch: more
                            ///< joins what only is near
  int members{4};      ///< segments that a point follows at the most; more is slower
  float overlap{2.4f}; ///< how far a segment is felt, typical radii: more is smoother,
                       ///< less leaves seams
};

void
listValues (SurfaceTuning& tuning, TunedValues& values);

} // namespace pcl_msf
