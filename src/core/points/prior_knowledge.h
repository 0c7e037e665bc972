// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/point_tuning.h"
#include "core/points/given_segments.h"
#include "core/points/point_matching.h"
#include <pcl_msf/cloud_constraints.h>

#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief A point of the source, where it is known to go, and where it lies. Scaled. */
struct KnownPoint {
  Eigen::Vector3f point;
  Eigen::Vector3d target;
  double weight{1.0};
  int place{0};  ///< the working point that it is, or moves with
  int sample{0}; ///< the sample that it moves with

  /** \brief What pulls at it. \param unit of the weight: pull of as many samples */
  PointPull
  pull (double unit) const;
};

/** \brief CloudConstraints in terms of the working clouds. Empty = nothing is known. */
struct PriorKnowledge {
  std::vector<KnownPoint> points;
  std::vector<float> weights;                     ///< per working point of the source
  std::vector<char> fixed;                        ///< per working segment
  std::vector<std::pair<int, RigidPose>> guesses; ///< of working segments, scaled

  /** \brief Weighs what pulls at working points. \param chosen those, one per pull;
   * empty = all of them in order */
  void
  weigh (const std::vector<int>& chosen, std::vector<PointPull>& pulls) const;
};

/** \throws InvalidInput naming the remedy for indices and labels that there are none of
 * \param source, target as given */
PriorKnowledge
priorKnowledge (const CloudConstraints& constraints,
                const PointClouds& clouds,
                const GivenSegments& segments,
                const std::vector<Eigen::Vector3f>& source,
                const std::vector<Eigen::Vector3f>& target,
                const PointMatchTuning& tuning);

/** \brief The rigid motion that takes known points from where they are to where they
 * are known to go; only a shift when they lie on a line.
 * \param known one or more \param at where they are */
RigidPose
commonMotion (const std::vector<KnownPoint>& known,
              const std::vector<Eigen::Vector3f>& at,
              const LimbTuning& tuning);

} // namespace pcl_msf
