// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/isometry.h"
#include "core/points/point_clouds.h"
#include "core/points/point_problem.h"
#include "core/points/solve_progress.h"

#include <vector>

namespace pcl_msf {

/** \brief Finds a motion per segment of the source, coarse to fine, then again with
 * limbs that moved far started from what their distances along the surface say. */
class PointSolve {
public:
  /** \param start of all segments, on scaled points
   * \param clouds, tuning must outlive this */
  PointSolve (const PointClouds& clouds,
              const RigidPose& start,
              const Tuning& tuning,
              int threads,
              SolveProgress& progress);

  void
  run ();

  const SurfaceSegments&
  segments () const
  {
    return cuts_[cut_];
  }
  const std::vector<RigidPose>&
  poses () const
  {
    return poses_;
  }
  const PointSamples&
  samples () const
  {
    return samples_;
  }
  /** \brief Against all of the target's points. */
  MatchTarget&
  fineTarget ()
  {
    return fine_;
  }

private:
  void
  enter (int cut);
  void
  match (const PointStage& stage, MatchTarget& target);
  std::vector<PointPair>
  isometricPairs ();
  void
  followPairs (const std::vector<PointPair>& pairs);
  double
  explained ();

  const PointClouds& clouds_;
  const PointTuning& tuning_;
  int threads_;
  SolveProgress& progress_;
  std::vector<SurfaceSegments> cuts_; ///< per stage
  int cut_{0};
  PointSamples samples_;
  std::vector<RigidPose> poses_; ///< per segment of the present cut
  MatchTarget coarse_;
  MatchTarget fine_;
};

} // namespace pcl_msf
