// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/rigid_parts.h"

#include "core/base/parallel_for.h"
#include "core/points/part_borders.h"
#include "core/points/part_seams.h"
#include "core/points/residual_scale.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace pcl_msf {

namespace {

class PartFinder {
public:
  PartFinder (const PointClouds& clouds,
              const PriorKnowledge& prior,
              PointSolve& solve,
              const PointTuning& tuning,
              int threads)
  : source_ (clouds.source.surface)
  , prior_ (prior)
  , segments_ (solve.segments())
  , target_ (solve.fineTarget())
  , spacing_ (clouds.target.surface.median_spacing)
  , tuning_ (tuning.parts)
  , brightness_ (tuning.brightness)
  , threads_ (threads)
  , poses_ (solve.poses())
  , all_{
        source_.points, source_.normals, segments_.members, clouds.source.texture.value}
  {}

  RigidParts
  run (bool merge)
  {
    part_of_.resize (segments_.size());
    std::iota (part_of_.begin(), part_of_.end(), 0);
    MovedPoints moved = movePoints (all_, poses_, threads_);
    std::vector<PointPull> pulls =
        target_.pulls (moved, fineRules (tuning_.reach * spacing_, tuning_), threads_);
    variance_ = std::pow (std::max (deviationOf (moved, pulls, tuning_.least_weight),
                                    tuning_.floor * spacing_),
                          2);
    if (!all_.brightness.empty())
      pulls = target_.pulls (moved, rules (tuning_.reach * spacing_), threads_);
    if (merge || segments_.given) {
      part_poses_ = poses_;
      if (merge)
        mergeSegments (pulls);
      chooseBodies();
      drawBorders();
      for (int round = 0; round < tuning_.polish; ++round)
        polish();
      for (int round = 0; round < tuning_.absorb && merge && absorb(); ++round)
        polish();
    }
    return result();
  }

private:
  void
  mergeSegments (const std::vector<PointPull>& pulls)
  {
    std::vector<SegmentLink> links;
    for (const SegmentLink& link : segments_.links)
      if (!segments_.isFixed (link.first) && !segments_.isFixed (link.second))
        links.push_back (link);
    const MergedParts merged = mergeParts (
        momentsOf (segments_.label, pulls), poses_, links, variance_, tuning_);
    part_of_ = merged.part_of;
    part_poses_ = merged.poses;
    for (int k = 0; k < segments_.size(); ++k)
      if (segments_.isFixed (k))
        part_poses_[part_of_[k]] = poses_[k];
  }
  /** By shape and brightness, each as precise as it is. */
  MatchRules
  rules (double distance) const
  {
    MatchRules rules = fineRules (distance, tuning_);
    rules.brightness = std::sqrt (variance_);
    rules.brightness_weight = brightness_.part_weight;
    rules.outlying = brightness_.outlying;
    return rules;
  }
  /** Of matches and known pairs, per label of the points. A pair of weight 1 is known
   * to about a spacing. */
  std::vector<RigidMoments>
  momentsOf (const std::vector<int>& label, std::vector<PointPull> pulls) const
  {
    prior_.weigh ({}, pulls);
    std::vector<RigidMoments> moments (part_poses_.size());
    for (int i = 0; i < source_.size(); ++i)
      moments[label[i]].add (source_.points[i].cast<double>(), pulls[i], 1.0);
    const double unit = variance_ / (spacing_ * spacing_);
    for (const KnownPoint& known : prior_.points)
      moments[label[known.place]].add (
          known.point.cast<double>(), known.pull (unit), 1.0);
    return moments;
  }
  /** Which parts are rigid bodies, and which of these are fitted on their own: small
   * ones keep what their neighbours told them. */
  void
  chooseBodies ()
  {
    std::vector<int> sizes (part_poses_.size(), 0);
    for (const int label : segments_.label)
      ++sizes[part_of_[label]];
    free_.assign (sizes.size(), 0);
    for (std::size_t p = 0; p < sizes.size(); ++p)
      free_[p] = sizes[p] >= tuning_.rigid_share * source_.size();
    rigid_ = free_;
    if (segments_.given)
      rigid_.assign (sizes.size(), 1);
    for (int k = 0; k < segments_.size(); ++k)
      if (segments_.isFixed (k))
        free_[part_of_[k]] = 0;
    for (int k = 0; k < segments_.size(); ++k)
      if (rigid_[part_of_[k]])
        poses_[k] = part_poses_[part_of_[k]];
  }
  /** Points between parts go with the one whose motion fits them best; given segments
   * stay whole. */
  void
  drawBorders ()
  {
    if (segments_.given)
      for (const int label : segments_.label)
        part_.push_back (part_of_[label]);
    else
      part_ = borders().draw (
          target_, rules (tuning_.reach * spacing_), spacing_, tuning_, threads_);
    for (const KnownPoint& known : prior_.points) {
      const int own = part_of_[segments_.label[known.place]];
      int& drawn = part_[known.place];
      if (rigid_[own] && rigid_[drawn] &&
          pairCost (known, own) < pairCost (known, drawn))
        drawn = own;
    }
    for (int i = 0; i < source_.size(); ++i)
      if (rigid_[part_[i]])
        all_.members[i] = borders().oneOf (part_[i]);
  }
  PartBorders
  borders () const
  {
    return {source_, segments_, part_of_, rigid_, poses_, all_.brightness};
  }
  void
  polish ()
  {
    const MovedPoints moved = movePoints (all_, poses_, threads_);
    MatchRules own = rules (spacing_);
    own.plane = tuning_.outlying * std::sqrt (variance_);
    const std::vector<PointPull> pulls = target_.pulls (moved, own, threads_);
    moments_ = momentsOf (part_, pulls);
    holdSeams (seamsBetween (source_, part_), part_poses_, rigid_, tuning_, moments_);
    for (std::size_t p = 0; p < part_poses_.size(); ++p)
      if (free_[p])
        part_poses_[p] = moments_[p].solve (part_poses_[p]);
    for (int k = 0; k < segments_.size(); ++k)
      if (rigid_[part_of_[k]])
        poses_[k] = part_poses_[part_of_[k]];
  }
  /** Halved squared deviations of a known pair with a part's motion. */
  double
  pairCost (const KnownPoint& known, int part) const
  {
    const Eigen::Vector3d moved = part_poses_[part] * known.point.cast<double>();
    return 0.5 * known.weight * (moved - known.target).squaredNorm() /
           (spacing_ * spacing_);
  }
  /** Do known pairs let a part go with another one? */
  bool
  pairsAllow (int part, int other) const
  {
    double cost = 0.0;
    for (const KnownPoint& known : prior_.points)
      if (part_[known.place] == part)
        cost += pairCost (known, other) - pairCost (known, part);
    return cost <= tuning_.allowance;
  }
  bool
  fixed (int part) const
  {
    const auto k = std::find (part_of_.begin(), part_of_.end(), part);
    return segments_.isFixed (static_cast<int> (k - part_of_.begin()));
  }
  /** Pairs of parts that touch, the smaller one first. */
  std::set<std::pair<int, int>>
  touchingParts (const std::vector<int>& sizes) const
  {
    std::set<std::pair<int, int>> pairs;
    for (const SurfaceSeam& seam : seamsBetween (source_, part_)) {
      int a = seam.first;
      int b = seam.second;
      if (std::make_pair (sizes[b], b) < std::make_pair (sizes[a], a))
        std::swap (a, b);
      if (rigid_[b] && !fixed (a) && !fixed (b) && pairsAllow (a, b))
        pairs.insert ({a, b});
    }
    return pairs;
  }
  /** Mean distance of points from the target, where they are or with another part. */
  double
  distanceOf (const std::vector<int>& points, int other)
  {
    PointSamples some;
    for (const int i : points) {
      some.points.push_back (source_.points[i]);
      some.normals.push_back (source_.normals[i]);
      if (!all_.brightness.empty())
        some.brightness.push_back (all_.brightness[i]);
      some.members.push_back (other >= 0 ? borders().oneOf (other) : all_.members[i]);
    }
    double sum = 0.0;
    for (const float d : target_.distances (movePoints (some, poses_, threads_),
                                            rules (tuning_.reach * spacing_),
                                            tuning_.limit * spacing_,
                                            threads_))
      sum += d;
    return sum / std::max<std::size_t> (1, points.size());
  }
  /** Parts that fit the target as well with a larger body's motion join that body.
   * \return did any? */
  bool
  absorb ()
  {
    std::vector<std::vector<int>> points (part_poses_.size());
    for (int i = 0; i < source_.size(); ++i)
      points[part_[i]].push_back (i);
    std::vector<int> sizes;
    for (const auto& list : points)
      sizes.push_back (static_cast<int> (list.size()));
    std::vector<int> into (points.size(), -1);
    std::vector<double> best (points.size(), 0.0);
    for (const auto& [a, b] : touchingParts (sizes)) {
      if (into[a] < 0 && best[a] == 0.0)
        best[a] = (1.0 + tuning_.worse_share) * distanceOf (points[a], -1) +
                  tuning_.worse * spacing_;
      const double distance = distanceOf (points[a], b);
      if (distance < best[a]) {
        best[a] = distance;
        into[a] = b;
      }
    }
    bool any = false;
    for (std::size_t a = 0; a < points.size(); ++a) {
      int b = into[a];
      while (b >= 0 && into[b] >= 0) // larger and larger
        b = into[b];
      if (b < 0)
        continue;
      any = true;
      for (const int i : points[a]) {
        part_[i] = b;
        all_.members[i] = borders().oneOf (b);
      }
      for (int k = 0; k < segments_.size(); ++k)
        if (part_of_[k] == static_cast<int> (a))
          part_of_[k] = b;
    }
    return any;
  }
  RigidParts
  result ()
  {
    if (part_.empty()) {
      part_ = segments_.label;
      part_poses_ = poses_;
      moments_.assign (poses_.size(), {});
    }
    RigidParts parts;
    std::vector<int> sizes (part_poses_.size(), 0);
    for (const int p : part_)
      ++sizes[p];
    std::vector<int> order (sizes.size());
    std::iota (order.begin(), order.end(), 0);
    std::stable_sort (order.begin(), order.end(), [&sizes] (int a, int b) {
      return sizes[a] > sizes[b];
    });
    std::vector<int> rank (order.size(), -1);
    for (const int p : order)
      if (sizes[p] > 0) {
        rank[p] = static_cast<int> (parts.poses.size());
        Matrix6 information;
        moments_[p].solve (part_poses_[p], &information);
        parts.poses.push_back (part_poses_[p]);
        parts.information.push_back (information / variance_);
        parts.sizes.push_back (sizes[p]);
      }
    for (const int p : part_)
      parts.part.push_back (rank[p]);
    MovedPoints moved = movePoints (all_, poses_, threads_);
    parts.points = std::move (moved.points);
    parts.normals = std::move (moved.normals);
    return parts;
  }

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
  double variance_{1.0};
  std::vector<int> part_of_;          ///< per segment
  std::vector<RigidPose> part_poses_; ///< per part
  std::vector<RigidMoments> moments_; ///< per part
  std::vector<char> rigid_;           ///< per part
  std::vector<char> free_;            ///< per part: fitted on its own
  std::vector<int> part_;             ///< per working point
};

} // namespace

RigidParts
findParts (const PointClouds& clouds,
           const PriorKnowledge& prior,
           PointSolve& solve,
           bool merge,
           const PointTuning& tuning,
           int threads)
{
  return PartFinder (clouds, prior, solve, tuning, threads).run (merge);
}

} // namespace pcl_msf
