// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/minimize.h"
#include "core/multi_frame_start.h"
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/oversegmentation.h>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief One window's estimation, from start to results: section 3.1 in order.
 *
 * The start solves adjacent frames; rounds then minimize Eq. 13 over all pairs at the
 * two finest levels, each with the segments carried anew by the present poses. */
class MultiFrameSolve {
public:
  MultiFrameSolve (const std::vector<RgbdFrame>& frames,
                   int reference,
                   const Oversegmentation& segments,
                   const EnergyParameters& energy,
                   const SolverParameters& solver,
                   const MultiframeParameters& multiframe);

  /** \param known motions that an earlier window found */
  MultiframeSceneFlow
  run (const RigidPose& guess, const std::vector<KnownStep>& known = {});

  /** \brief Labels of a frame, carried there by the present poses. */
  cv::Mat
  labelsIn (int frame) const;

private:
  struct Round {
    enum Place { First, Middle, Last };
    int level;
    int iterations;
    Place place;
  };

  SolverParameters
  watchedSolver ();
  void
  start (const RigidPose& guess, const std::vector<KnownStep>& known);
  std::vector<cv::Mat>
  carryLabels () const;
  void
  fitExposures (int level, const cv::Mat& labels);
  void
  fuseDepth ();
  void
  round (const Round& round, double begin, double end);
  void
  merge ();
  void
  reassign ();
  MultiframeSceneFlow
  finish ();
  SceneFlow
  resultFor (int frame);
  void
  concludeReport (MultiframeSceneFlow& result);

  const std::vector<RgbdFrame>& frames_;
  const FramePairs pairs_;
  const Oversegmentation& segments_;
  const EnergyParameters energy_;
  const SolverParameters user_;
  const MultiframeParameters multiframe_;
  double begin_{0.0}; ///< of the progress that the present stage covers
  double share_{1.0};
  bool cancelled_{false};
  const SolverParameters solver_;
  SolveMonitor monitor_;
  WindowScene scene_;
  WindowState state_;
  std::unique_ptr<WindowLevel> level_; ///< of the last round
  Report report_;
};

} // namespace pcl_msf
