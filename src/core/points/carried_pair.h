// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/point_frame.h"
#include "core/points/point_terms.h"

#include <vector>

namespace pcl_msf {

/** \brief Two targets that follow each other: points of the earlier one go with the
 * segments that the source's motion has put there, into the later one. */
class CarriedPair {
public:
  /** \param near how far points may be from the source as it has moved; others take no
   * part */
  CarriedPair (const PointFrame& from,
               const PointFrame& to,
               const PointEnergyWeights& weights,
               double near,
               int threads);

  PointTerms&
  terms ()
  {
    return terms_;
  }
  /** \brief Those that take part. */
  const PointSamples&
  samples () const
  {
    return samples_;
  }
  /** \brief Per segment, from the earlier target to the later one. */
  const std::vector<RigidPose>&
  poses () const
  {
    return poses_;
  }

  /** \brief What pulls at the samples where they are now. */
  std::vector<PointPull>
  pulls (const MatchRules& rules);

private:
  int threads_;
  PointSamples samples_;
  PointSamples none_; ///< known points
  SurfaceSegments segments_;
  std::vector<RigidPose> poses_;
  MatchTarget target_;
  PointTerms terms_;
};

} // namespace pcl_msf
