// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/part_borders.h"
#include "core/points/part_merging.h"
#include "core/points/part_seams.h"
#include "core/points/point_frame.h"
#include "core/points/rigid_moments.h"

#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief Which parts the source's working points and segments belong to. */
struct PartLabels {
  std::vector<int> part_of; ///< per segment
  std::vector<int> part;    ///< per working point
  std::vector<char> rigid;  ///< per part: it moves as one up to its border
  std::vector<char> free;   ///< per part: fitted on its own
};

/** \brief The parts of a source as one target sees them: their motions into it, and how
 * well these fit. */
class PartView {
public:
  PartView (const PointFrame& frame, const PointTuning& tuning, int threads);

  /** \brief Of single segments. */
  MergeView
  mergeView () const;
  BorderView
  borderView ();

  /** \brief Parts get motions. \param poses per part */
  void
  take (std::vector<RigidPose> poses)
  {
    part_poses_ = std::move (poses);
  }
  const RigidPose&
  segmentPose (int segment) const
  {
    return poses_[segment];
  }
  void
  setPartPose (int part, const RigidPose& pose)
  {
    part_poses_[part] = pose;
  }

  /** \brief Segments of rigid parts get the motions of these. */
  void
  followParts (const PartLabels& labels);
  /** \brief A point follows a part, by a segment of it. */
  void
  follow (int point, const std::vector<Membership>& members)
  {
    all_.members[point] = members;
  }

  /** \brief Fits the free parts' motions to the target once more. */
  void
  polish (const PartLabels& labels, const BodySeams& seams);

  /** \brief The same, but motions that lead away from the target are taken back: parts
   * that are held by each other's seams may draw each other away. */
  void
  polishWithCare (const PartLabels& labels, const BodySeams& seams);
  /** \brief Before points change parts. */
  void
  forgetDistances ()
  {
    least_.clear();
  }

  /** \brief Halved squared deviations of known pairs with a part's motion, in spacings.
   */
  double
  pairCost (const KnownPoint& known, int part) const;
  /** \brief What known pairs of a part lose when it goes with another one. */
  double
  pairLoss (const PartLabels& labels, int part, int other) const;

  /** \brief Mean distance of points from the target. \param members of all of them in
   * place of their own; empty = their own */
  double
  distanceOf (const std::vector<int>& points, const std::vector<Membership>& members);

  /** \brief The pose of a part. \param[out] information of its parameters */
  RigidPose
  poseOf (int part, Matrix6& information) const;
  /** \brief When nothing was merged: segments are parts. */
  void
  takeSegments ()
  {
    part_poses_ = poses_;
    moments_.assign (poses_.size(), {});
  }
  MovedPoints
  moved () const
  {
    return movePoints (all_, poses_, threads_);
  }
  const std::vector<KnownPoint>&
  known () const
  {
    return prior_.points;
  }
  double
  spacing () const
  {
    return spacing_;
  }

private:
  MatchRules
  rules (double distance) const;
  std::vector<RigidMoments>
  momentsOf (const std::vector<int>& label,
             std::vector<PointPull> pulls,
             std::size_t parts) const;
  std::vector<double>
  partDistances (const PartLabels& labels);

  const Surface& source_;
  const PriorKnowledge& prior_;
  const SurfaceSegments& segments_;
  MatchTarget& target_;
  double spacing_;
  const PointPartTuning& tuning_;
  const PointBrightnessTuning& brightness_;
  int threads_;
  std::vector<RigidPose> poses_; ///< per segment
  PointSamples all_;             ///< the working points
  std::vector<PointPull> pulls_; ///< at these, by segments
  double variance_{1.0};
  std::vector<RigidPose> part_poses_; ///< per part
  std::vector<RigidMoments> moments_; ///< per part
  std::vector<double> least_;         ///< per part, distance from the target so far
};

} // namespace pcl_msf
