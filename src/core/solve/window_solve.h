// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/energy/minimize.h"
#include "core/result/outcome.h"
#include "core/solve/followed_motion.h"
#include "core/solve/upcoming_levels.h"
#include "core/solve/window_start.h"
#include "core/start/pair_start.h"
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/oversegmentation.h>

#include <memory>
#include <vector>

namespace pcl_msf {

/** \brief One estimation over two frames (section 3) or more (section 3.1), from start
 * to results: a start, then a schedule of rounds.
 *
 * Two frames start with poses that optical flow suggests and go from coarse to fine. A
 * window of more starts with its frames one by one (WindowStart) and minimizes over all
 * pairs at the finest level, in each round with the segments carried anew by the
 * present poses. */
class WindowSolve {
public:
  WindowSolve (const std::vector<RgbdFrame>& frames,
               int reference,
               const Oversegmentation& segments,
               const EnergyParameters& energy,
               const SolverParameters& solver,
               const MultiframeParameters& multiframe,
               const Tuning& tuning);

  /** \param known motions that an earlier window found */
  MultiframeSceneFlow
  run (const RigidPose& guess, const std::vector<KnownStep>& known = {});

  /** \brief Two frames: has run () begin at these poses, one per segment, without
   * looking for better ones. */
  void
  startFrom (const std::vector<RigidPose>& poses)
  {
    given_start_ = poses;
  }

  /** \brief Two frames: has run () begin at half resolution with motions and bodies
   * that are nearly known, and look for others only where they leave something
   * unexplained; where that is too much, it begins as ever, at the dominant motion. */
  void
  follow (FollowedMotion motion)
  {
    followed_ = std::make_unique<FollowedMotion> (std::move (motion));
  }

  /** \brief Has each segment solved for by itself at the coarsest level, too, whatever
   * pose it starts at: slower, but first bodies, which a tracker keeps, are surer. */
  void
  keepSegmentsApart ()
  {
    apart_ = true;
  }

  /** \brief Leaves the images of results empty. */
  void
  leaveImagesOut ()
  {
    dense_ = false;
  }

  /** \brief Did run () begin as follow () says? */
  bool
  follows () const
  {
    return follows_;
  }

  /** \brief Two frames: run () down to a level, without a result; what a window of more
   * begins with. */
  void
  solve (const RigidPose& guess, int finest_level);

  /** \brief Two frames: the whole of what follow () begins, without a result. \return
   * did the motions explain the frame? Else nothing was solved. */
  bool
  solveFollowed ();

  /** \brief Labels of a frame at a level, carried there by the present poses. */
  cv::Mat
  labelsIn (int frame, int level = 0) const;

  const WindowState&
  state () const
  {
    return state_;
  }
  /** \brief Two frames: per segment, what a residual cost at half resolution. */
  const std::vector<double>&
  fit () const
  {
    return fit_;
  }
  /** \brief Two frames: what the finest level's brightness errs alike, see WindowScene.
   */
  double
  brightnessArea () const
  {
    return brightness_area_;
  }
  const WindowScene&
  scene () const
  {
    return scene_;
  }

private:
  static constexpr double kStartShare = 0.5; ///< of a window's work

  /** What is done on a level, in this order. */
  struct Round {
    const char* stage;
    int level;
    double begin, end; ///< of the progress
    int iterations;
    bool anew{true};      ///< with a new level, segments carried by the present poses
    bool results{false};  ///< the level is to tell dense results, too
    bool fuse{false};     ///< with the depth of all frames
    bool together{false}; ///< segments of one pose are one body for the solve
    bool propose{false};  ///< segments may jump
    bool spread{false};   ///< lost ones alone; without jumps there is no solve
    bool measure{false};  ///< what residuals are worth, after the solve
    bool presort{false};  ///< bodies merge before the solve, too
    bool rescale_noise{false}; ///< of rigid bodies, by their own residuals
    bool merge{false};      ///< after the solve, and segments choose among the bodies
    bool keep_worth{false}; ///< residuals are worth what they were; else they are
                            ///< measured after merging
    bool last{false};       ///< hidden segments follow, and bodies merge once more
  };

  SolverParameters
  watchedSolver ();
  bool
  isPair () const
  {
    return pairs_.frames() == 2;
  }
  std::vector<Round>
  pairSchedule (int finest_level) const;
  void
  addSpreads (std::vector<Round>& rounds) const;
  void
  addBodies (std::vector<Round>& rounds) const;
  std::vector<Round>
  windowSchedule () const;
  std::vector<Round>
  followSchedule () const;
  void
  solve (const std::vector<Round>& schedule);
  void
  measureNoise ();
  void
  start (const RigidPose& guess, const std::vector<KnownStep>& known);
  bool
  startFollowing ();
  int
  coarsestWhole () const;
  void
  enterWhole (int level);
  RigidPose
  registerWhole (const RigidPose& guess);
  void
  guessCommonStep ();
  void
  compareExposure (int level, const SegmentPixels& points);
  void
  takeBestGuesses ();
  std::vector<double>
  costsPerResidual () const;
  std::vector<char>
  lostSince (const std::vector<double>& costs) const;
  bool
  partLost ();
  void
  round (const Round& round);
  void
  enterLevel (const Round& round);
  LevelNeeds
  needsOf (const Round& round) const;
  void
  enterPrepared (int level, LevelPoints points);
  void
  prepareUpcoming (const std::vector<Round>& later);
  std::vector<cv::Mat>
  carryLabels (int level) const;
  void
  fitExposures (int level, const cv::Mat& labels);
  void
  fuseDepth ();
  void
  minimize (int iterations, const std::vector<char>& moving = {});
  std::vector<char>
  spreadMotions ();
  std::vector<char>
  movingBodies (const std::vector<char>& jumped) const;
  void
  measureCorrelation (int level);
  void
  merge ();
  void
  reassign ();
  MultiframeSceneFlow
  finish ();
  SceneFlow
  resultFor (int frame);
  void
  refine (int frame, SceneFlow& result) const;
  /** How sure the result of a pair is. \param camera of its frame */
  void
  fillConfidence (const DataTerm& data,
                  int pair,
                  const PinholeCamera& camera,
                  SceneFlow& result) const;
  std::vector<Judgement>
  judge (MultiframeSceneFlow& result) const;
  void
  finishImages (MultiframeSceneFlow& result);
  void
  tellEnd () const;

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
  const int levels_;
  SolveMonitor monitor_;
  WindowScene scene_;
  PairStart pair_start_;
  std::vector<RigidPose> given_start_;       ///< in place of a search; empty = search
  std::unique_ptr<FollowedMotion> followed_; ///< likewise
  bool follows_{false};
  bool apart_{false};
  bool dense_{true};
  WindowState state_;
  std::vector<double> fit_;
  double brightness_area_{1.0};        ///< of the scene, once level 0 is entered
  std::unique_ptr<WindowLevel> level_; ///< the present one
  Report report_;
  UpcomingLevels upcoming_; ///< after the first
};

} // namespace pcl_msf
