// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/given_segments.h"
#include "core/points/point_frame.h"
#include <pcl_msf/cloud_flow_estimator.h>

#include <chrono>
#include <string>
#include <vector>

namespace pcl_msf {

/** \brief A target as it came in. */
struct GivenTarget {
  InputPoints points;
  const CloudBrightness* brightness{nullptr};
  std::string name; ///< in messages
};

/** \brief A source and its targets as they came in. All must outlive the window. */
struct GivenClouds {
  InputPoints source;
  std::vector<GivenTarget> targets; ///< in the order of time
  int reference{0};                 ///< targets that come before the source
  const std::vector<int>& segments;
  double brightness_weight{1.0};
};

/** \brief Registers a source to one target or, jointly, to several. */
class CloudWindow {
public:
  /** All must outlive this. \throws InvalidInput naming the remedy */
  CloudWindow (const GivenClouds& given,
               const SolverParameters& solver,
               const CloudConstraints& constraints);

  /** \param start where to begin, as given \param concatenation_weight
   * lambda \return per target */
  std::vector<CloudFlow>
  run (const RigidPose& start, double concatenation_weight);

private:
  PointClouds
  prepare (int target) const;
  CloudConstraints
  constraintsOf (int target, const CloudConstraints& all) const;
  void
  solve (PointFrame& frame, const RigidPose& start);
  std::unique_ptr<PointSolve>
  solveFrom (const PointFrame& frame, const RigidPose& start, bool chained);
  void
  chooseStart (PointFrame& frame, const RigidPose& start);
  double
  seconds () const;

  const GivenClouds& given_;
  const SolverParameters& solver_;
  std::chrono::steady_clock::time_point begin_;
  Tuning tuning_;
  int threads_;
  SolveProgress progress_;
  GivenSegments segments_;
  std::vector<PointFrame> frames_; ///< per target
  double segment_seconds_{0.0};
};

} // namespace pcl_msf
