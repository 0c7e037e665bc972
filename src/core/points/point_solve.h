// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/isometry.h"
#include "core/points/point_clouds.h"
#include "core/points/point_problem.h"
#include "core/points/prior_knowledge.h"
#include "core/points/sample_cuts.h"
#include "core/points/solve_progress.h"

#include <vector>

namespace pcl_msf {

/** \brief Which anchors a fresh start relies on. */
struct LimbAnchors {
  int count;        ///< pairs that may be
  double agreement; ///< of one with the others, mean, at least
};

/** \brief Finds a motion per segment of the source, coarse to fine, then again with
 * limbs that moved far started from what their distances along the surface say. Known
 * pairs pull all the way. */
class PointSolve {
public:
  /** \param start of all segments, on scaled points
   * \param clouds, prior, tuning must outlive this */
  PointSolve (const PointClouds& clouds,
              const PriorKnowledge& prior,
              const RigidPose& start,
              const Tuning& tuning,
              int threads,
              SolveProgress& progress);

  /** \brief Begins at the motions that another solve found for the same source, those
   * of its last segments: these lead to places that are near where it ended. */
  void
  beginAt (const std::vector<RigidPose>& poses);

  void
  run ();

  /** \brief Has it led all of one cloud to the other, but for what is cut off, and no
   * limb to where it should not be? */
  bool
  found ()
  {
    return allCovered();
  }
  /** \brief What is found of both clouds, less the known pairs that are missed. */
  double
  explained ();

  /** \brief What pulls at the samples and then at the known points where they are now,
   * by all of the target's points. \param distance scale of the robust weight */
  std::vector<PointPull>
  finePulls (double distance);

  /** \brief How its matches are found. \param distance scale of the robust weight */
  MatchRules
  rulesOf (double distance) const;

  /** \brief Of all working points once it has run. */
  const SurfaceSegments&
  segments () const
  {
    return cuts_[cut_].segments;
  }
  const std::vector<RigidPose>&
  poses () const
  {
    return poses_;
  }
  std::vector<RigidPose>&
  poses ()
  {
    return poses_;
  }
  /** \brief The points of known pairs. */
  const PointSamples&
  known () const
  {
    return known_;
  }
  const PointSamples&
  samples () const
  {
    return samples_;
  }
  /** \brief Of the samples. */
  const std::vector<int>&
  sampleLabels () const
  {
    return cuts_[cut_].label;
  }
  /** \brief What one rigid motion, which the parts' gave way to, leaves of both clouds;
   * 0 when they did not. */
  double
  scattered () const
  {
    return scattered_;
  }
  /** \brief Is brightness as the motion says, or is there none? */
  bool
  brightnessAgrees ();
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
  match (const PointStage& stage,
         MatchTarget& target,
         const std::vector<PointPair>& pairs = {});
  void
  takeBrightness (const MatchTarget& target);
  MatchRules
  tightRules () const;
  std::vector<PointPair>
  isometricPairs (const LimbAnchors& anchors);
  void
  addPairs (const MovedPoints& moved,
            const std::vector<PointPair>& pairs,
            double scale,
            double share,
            std::vector<PointPull>& pulls) const;
  void
  addKnown (double share, std::vector<PointPull>& pulls) const;
  void
  followPairs (const std::vector<PointPair>& pairs);
  double
  missed () const;
  void
  descend (int first, int last);
  RigidPose
  registerWhole (const RigidPose& start);
  std::pair<double, double>
  uncovered (const std::vector<RigidPose>& poses);
  void
  preferWhole (const RigidPose& start);
  void
  chooseStart ();
  bool
  startAnew (const std::vector<PointPair>& pairs);
  double
  conflicting (const std::vector<PointPair>& pairs) const;
  bool
  allCovered ();
  bool
  tryAgain (const std::vector<PointPair>& pairs);
  void
  seekLimbs ();

  const PointClouds& clouds_;
  const PriorKnowledge& prior_;
  const PointTuning& tuning_;
  int threads_;
  SolveProgress& progress_;
  std::vector<SampleCut> cuts_; ///< per stage
  int cut_{0};
  PointSamples samples_;
  PointSamples known_;           ///< points of known pairs
  std::vector<RigidPose> poses_; ///< per segment of the present cut
  double most_explained_{0.0};   ///< where fresh starts begin
  double scattered_{0.0};
  bool free_{false}; ///< nothing is known beforehand but one start of all
  MatchTarget coarse_;
  MatchTarget fine_;
};

} // namespace pcl_msf
