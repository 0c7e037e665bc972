// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/rigid_pose.h>

#include <string>
#include <vector>

namespace pcl_msf {

/** \brief A point of the source that is known to be one of the target. */
struct KnownPair {
  int source{0};      ///< index
  int target{0};      ///< index
  double weight{1.0}; ///< (0, 1e9]; 1 = right to about the distance between neighbours
  int cloud{0}; ///< of several targets the one that is meant, from 0, in the order
                ///< of time
};

/** \brief Where a given segment begins: of several targets in the one after the source,
 * or before it when there is none after it. */
struct SegmentGuess {
  int segment{0}; ///< label
  RigidPose target_from_source;
};

/** \brief What is known of the motion between two clouds without a grid before they are
 * registered. Nothing by default.
 *
 * Pairs pull at their points from the first step to the last, whatever lies nearer: a
 * few true ones lead limbs and symmetric bodies to their place that nearest neighbours
 * miss. They are soft: at first a pair of weight 1 counts as all matches of its segment
 * together, in the end hardly more than one match. One of weight 1e6 or more is hard:
 * it is kept as exactly as the motion of its segment can. They are not checked: leave
 * uncertain ones out. Pairs of points that are not finite, in no segment
 * or left out have no effect.
 *
 * Segments are named by their labels as given: those of the label cloud, or the
 * cluster's place in the list. */
struct PCL_MSF_EXPORT CloudConstraints {
  std::vector<KnownPair> pairs;
  std::vector<float> point_weights; ///< per source point, [0, 1e6]: of its matches; 0 =
                                    ///< it only follows; empty = 1 each
  std::vector<int> fixed_segments;  ///< keep the pose that they begin with, by default
                                    ///< where they are, in all targets; join no part
  std::vector<SegmentGuess> guesses; ///< for single segments in place of the guess for
                                     ///< all; the last one counts

  /** \param[out] why when not null and the answer is no: which value and its range.
   * Whether indices and labels exist is judged with the clouds. */
  bool
  isValid (std::string* why = nullptr) const;

  /** \brief Is nothing known? */
  bool
  empty () const
  {
    return pairs.empty() && point_weights.empty() && fixed_segments.empty() &&
           guesses.empty();
  }
};

} // namespace pcl_msf
