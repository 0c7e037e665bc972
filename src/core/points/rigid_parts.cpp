// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/rigid_parts.h"

#include "core/base/parallel_for.h"
#include "core/points/part_seams.h"
#include "core/points/residual_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace pcl_msf {

namespace {

MatchRules
fineRules (double distance, const PointPartTuning& tuning)
{
  MatchRules rules;
  rules.distance = distance;
  rules.normal_length = tuning.normal_length;
  rules.isotropy = tuning.isotropy;
  rules.backward = 0.0;
  return rules;
}

class PartFinder {
public:
  PartFinder (const PointClouds& clouds,
              PointSolve& solve,
              const PointPartTuning& tuning,
              int threads)
  : source_ (clouds.source.surface)
  , segments_ (solve.segments())
  , target_ (solve.fineTarget())
  , spacing_ (clouds.target.surface.median_spacing)
  , tuning_ (tuning)
  , threads_ (threads)
  , poses_ (solve.poses())
  , all_{source_.points, source_.normals, segments_.members}
  {}

  RigidParts
  run (bool merge)
  {
    part_of_.resize (segments_.size());
    std::iota (part_of_.begin(), part_of_.end(), 0);
    MovedPoints moved = movePoints (all_, poses_, threads_);
    std::vector<PointPull> pulls =
        target_.pulls (moved, fineRules (tuning_.reach * spacing_, tuning_), threads_);
    variance_ =
        std::pow (std::max (deviationOf (moved, pulls), tuning_.floor * spacing_), 2);
    if (merge) {
      mergeSegments (pulls);
      chooseBodies();
      drawBorders();
      for (int round = 0; round < tuning_.polish; ++round)
        polish();
      for (int round = 0; round < tuning_.absorb && absorb(); ++round)
        polish();
    }
    return result();
  }

private:
  void
  mergeSegments (const std::vector<PointPull>& pulls)
  {
    std::vector<RigidMoments> moments (segments_.size());
    for (int i = 0; i < source_.size(); ++i)
      moments[segments_.label[i]].add (source_.points[i].cast<double>(), pulls[i], 1.0);
    const MergedParts merged =
        mergeParts (moments, poses_, segments_.links, variance_, tuning_);
    part_of_ = merged.part_of;
    part_poses_ = merged.poses;
  }
  /** Which parts are rigid bodies. */
  void
  chooseBodies ()
  {
    std::vector<int> sizes (part_poses_.size(), 0);
    for (const int label : segments_.label)
      ++sizes[part_of_[label]];
    rigid_.assign (sizes.size(), 0);
    for (std::size_t p = 0; p < sizes.size(); ++p)
      rigid_[p] = sizes[p] >= tuning_.rigid_share * source_.size();
    for (int k = 0; k < segments_.size(); ++k)
      if (rigid_[part_of_[k]])
        poses_[k] = part_poses_[part_of_[k]];
  }
  /** Points between parts go with the one whose motion fits them best. */
  void
  drawBorders ()
  {
    constexpr int most = 3; // parts that a point may choose among
    const int n = source_.size();
    std::vector<std::array<int, most>> parts (n);
    std::vector<std::array<float, most>> costs (n);
    parallelFor (threads_, n, 64, [&] (int i) {
      parts[i].fill (-1);
      costs[i].fill (0.0f);
      int count = 0;
      const auto offer = [&] (int part) {
        for (int c = 0; c < count; ++c)
          if (parts[i][c] == part)
            return;
        if (count < most)
          parts[i][count++] = part;
      };
      offer (part_of_[segments_.label[i]]);
      for (const Membership& m : segments_.members[i])
        if (rigid_[part_of_[m.segment]])
          offer (part_of_[m.segment]);
    });
    chooseParts<most> (parts, costs);
  }
  template <int Most>
  void
  chooseParts (const std::vector<std::array<int, Most>>& parts,
               std::vector<std::array<float, Most>>& costs)
  {
    const int n = source_.size();
    part_.resize (n);
    for (int c = 0; c < Most; ++c) { // one candidate after the other, all points
      PointSamples some;
      std::vector<int> place;
      for (int i = 0; i < n; ++i)
        if (parts[i][1] >= 0 && parts[i][c] >= 0) {
          const bool rigid = rigid_[parts[i][c]] != 0;
          some.points.push_back (source_.points[i]);
          some.normals.push_back (source_.normals[i]);
          some.members.push_back (rigid ? oneOf (parts[i][c]) : segments_.members[i]);
          place.push_back (i);
        }
      const MovedPoints moved = movePoints (some, poses_, threads_);
      const std::vector<float> cost =
          target_.distances (moved,
                             fineRules (tuning_.reach * spacing_, tuning_),
                             tuning_.limit * spacing_,
                             threads_);
      for (std::size_t k = 0; k < place.size(); ++k)
        costs[place[k]][c] = cost[k];
    }
    for (int round = 0; round < tuning_.smoothing; ++round)
      smooth<Most> (parts, costs);
    for (int i = 0; i < n; ++i) {
      int best = 0;
      for (int c = 1; c < Most; ++c)
        if (parts[i][c] >= 0 && costs[i][c] < costs[i][best])
          best = c;
      part_[i] = parts[i][best];
      if (rigid_[part_[i]])
        all_.members[i] = oneOf (part_[i]);
    }
  }
  template <int Most>
  void
  smooth (const std::vector<std::array<int, Most>>& parts,
          std::vector<std::array<float, Most>>& costs) const
  {
    const std::vector<std::array<float, Most>> before = costs;
    parallelFor (threads_, source_.size(), 256, [&] (int i) {
      if (parts[i][1] < 0)
        return;
      for (int c = 0; c < Most && parts[i][c] >= 0; ++c) {
        float sum = before[i][c];
        float weight = 1.0f;
        for (const SurfaceEdge* e = source_.graph.begin (i); e != source_.graph.end (i);
             ++e)
          for (int d = 0; d < Most; ++d)
            if (parts[e->to][d] == parts[i][c] && parts[e->to][1] >= 0) {
              sum += before[e->to][d];
              weight += 1.0f;
            }
        costs[i][c] = sum / weight;
      }
    });
  }
  /** A point that follows a part as a whole. */
  std::vector<Membership>
  oneOf (int part) const
  {
    const auto k = std::find (part_of_.begin(), part_of_.end(), part);
    return {{static_cast<int> (k - part_of_.begin()), 1.0f}};
  }
  void
  polish ()
  {
    const MovedPoints moved = movePoints (all_, poses_, threads_);
    MatchRules rules = fineRules (spacing_, tuning_);
    rules.plane = tuning_.outlying * std::sqrt (variance_);
    const std::vector<PointPull> pulls = target_.pulls (moved, rules, threads_);
    moments_.assign (part_poses_.size(), {});
    for (int i = 0; i < source_.size(); ++i)
      moments_[part_[i]].add (source_.points[i].cast<double>(), pulls[i], 1.0);
    holdSeams (seamsBetween (source_, part_), part_poses_, rigid_, tuning_, moments_);
    for (std::size_t p = 0; p < part_poses_.size(); ++p)
      if (rigid_[p])
        part_poses_[p] = moments_[p].solve (part_poses_[p]);
    for (int k = 0; k < segments_.size(); ++k)
      if (rigid_[part_of_[k]])
        poses_[k] = part_poses_[part_of_[k]];
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
      if (rigid_[b])
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
      some.members.push_back (other >= 0 ? oneOf (other) : all_.members[i]);
    }
    double sum = 0.0;
    for (const float d :
         target_.distances (movePoints (some, poses_, threads_),
                            fineRules (tuning_.reach * spacing_, tuning_),
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
        all_.members[i] = oneOf (b);
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
  const SurfaceSegments& segments_;
  MatchTarget& target_;
  double spacing_;
  const PointPartTuning& tuning_;
  int threads_;
  std::vector<RigidPose> poses_; ///< per segment
  PointSamples all_;             ///< the working points
  double variance_{1.0};
  std::vector<int> part_of_;          ///< per segment
  std::vector<RigidPose> part_poses_; ///< per part
  std::vector<RigidMoments> moments_; ///< per part
  std::vector<char> rigid_;           ///< per part
  std::vector<int> part_;             ///< per working point
};

} // namespace

RigidParts
findParts (const PointClouds& clouds,
           PointSolve& solve,
           bool merge,
           const PointPartTuning& tuning,
           int threads)
{
  return PartFinder (clouds, solve, tuning, threads).run (merge);
}

} // namespace pcl_msf
