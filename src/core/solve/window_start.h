// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/window_level.h"
#include "core/energy/solve_monitor.h"
#include "core/motion/motion_state.h"
#include "core/solve/followed_motion.h"
#include "core/window/frame_pairs.h"
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/parameters.h>

#include <optional>
#include <vector>

namespace pcl_msf {

class WindowSolve;

/** \brief Motions between two adjacent frames that an earlier window found. */
struct KnownStep {
  int from; ///< the frame nearer to the reference
  int to;
  std::vector<RigidPose> poses; ///< per segment, `to_from_from`
  std::vector<char> known;      ///< per segment
};

/** \brief What a window's optimization starts from (section 3.3).
 *
 * The reference and the frame next to it by the solver of two frames; those beyond are
 * followed from the reference, where its bodies would be at their last speed. Where a
 * frame cannot be followed, and without brightness, two adjacent ones are solved, with
 * the segments carried so far. Pairs between other frames by concatenation. */
class WindowStart {
public:
  WindowStart (const std::vector<RgbdFrame>& frames,
               const FramePairs& pairs,
               const Oversegmentation& segments,
               const EnergyParameters& energy,
               const SolverParameters& solver,
               const Tuning& tuning);

  /** \param guess of the first solve from the reference
   * \param known steps that need no solve */
  void
  run (const RigidPose& guess, const std::vector<KnownStep>& known);

  /** \brief Segments that moved alike into all frames are one body, without brightness
   * each is one; poses of non-adjacent pairs by concatenation. */
  WindowState
  state () const;

  /** \brief Did light change between two adjacent frames? */
  bool
  lightChanged () const
  {
    return light_changed_;
  }
  const std::vector<BrightnessChange>&
  exposure () const
  {
    return exposure_;
  }
  const NoiseModel&
  noise () const
  {
    return noise_;
  }
  const std::vector<SegmentLink>&
  links () const
  {
    return links_;
  }

  /** \brief Per segment, reference frame, metres. */
  std::vector<Eigen::Vector3d>
  centroids () const;

private:
  /** One adjacent pair's motions, per segment of the reference. */
  struct Step {
    std::vector<RigidPose> poses;
    std::vector<int> body; ///< -1 = the segment is not seen there
  };

  bool
  followStep (int before, int from, int to);
  FollowedMotion
  predict (int before, int from) const;
  void
  learn (const WindowSolve& solve);
  SolverParameters
  solverOfRest () const;
  void
  takeNoise (const NoiseModel& noise);
  void
  solveStep (int from, int to, const RigidPose& guess);
  void
  applyStep (const KnownStep& known);
  void
  linkSegments ();
  void
  fillUnseen (Step& step) const;
  RigidPose
  dominantPose (const Step& step) const;
  void
  compose (int from, int to);
  void
  carryTo (int frame);
  std::vector<RigidPose>
  chainedPoses (int pair) const;
  std::vector<int>
  commonBodies () const;

  const std::vector<RgbdFrame>& frames_;
  const FramePairs& pairs_;
  const Oversegmentation& segments_;
  const EnergyParameters& energy_;
  const SolverParameters& solver_;
  const Tuning& tuning_;
  const SolveMonitor clock_;                     ///< of the time budget
  std::vector<cv::Mat> labels_;                  ///< per frame; empty: not needed yet
  std::vector<Step> steps_;                      ///< per pair; adjacent ones filled
  std::vector<std::vector<RigidPose>> to_frame_; ///< per frame, per segment
  std::vector<BrightnessChange> exposure_;       ///< per frame
  bool light_changed_{false};
  std::vector<SegmentLink> links_; ///< of the reference
  std::vector<double> link_weights_;
  NoiseModel noise_;
  /** Of the last frame in this direction, but for bodies and guesses. */
  std::optional<FollowedMotion> learnt_;
};

} // namespace pcl_msf
