// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/body_parts.h"

#include "core/base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pcl_msf {

namespace {

constexpr double kRigidShare = 0.02; // of the points: a body of its own
constexpr int kPolish = 4;           // rounds of fitting the bodies' motions
constexpr double kLeastScale = 0.25; // of residuals, spacings of the target
constexpr int kSmoothing = 2;        // rounds over neighbours when borders are drawn

MatchRules
fineRules (double distance)
{
  MatchRules rules;
  rules.distance = distance;
  rules.normal_length = 0.01;
  rules.isotropy = 0.01; // what planes leave free stays near
  rules.backward = 0.0;
  return rules;
}

double
deviationOf (const MovedPoints& moved, const std::vector<PointPull>& pulls)
{
  std::vector<double> residuals;
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    if (!(pulls[i].weight > 0.1))
      continue;
    const Eigen::Vector3d x = moved.points[i].cast<double>();
    const double cost = x.dot (pulls[i].a * x) - 2.0 * pulls[i].b.dot (x) +
                        2.0 * pulls[i].c;
    residuals.push_back (std::max (0.0, cost / pulls[i].weight));
  }
  if (residuals.empty())
    return 0.0;
  const auto middle = residuals.begin() + residuals.size() / 2;
  std::nth_element (residuals.begin(), middle, residuals.end());
  return 1.4826 * std::sqrt (*middle);
}

class PartFinder {
public:
  PartFinder (const PointClouds& clouds, PointSolve& solve, int threads)
  : source_ (clouds.source.surface)
  , segments_ (solve.segments())
  , target_ (solve.fineTarget())
  , spacing_ (clouds.target.surface.median_spacing)
  , threads_ (threads)
  , poses_ (solve.poses())
  , all_{source_.points, source_.normals, segments_.members}
  {}

  BodyParts
  run (bool merge)
  {
    part_of_.resize (segments_.size());
    std::iota (part_of_.begin(), part_of_.end(), 0);
    MovedPoints moved = movePoints (all_, poses_, threads_);
    std::vector<PointPull> pulls =
        target_.pulls (moved, fineRules (2.0 * spacing_), threads_);
    variance_ = std::pow (std::max (deviationOf (moved, pulls), kFloor * spacing_), 2);
    if (merge) {
      mergeSegments (pulls);
      chooseBodies();
      drawBorders();
      for (int round = 0; round < kPolish; ++round)
        polish();
    }
    return result();
  }

private:
  static constexpr double kFloor = 0.1; // spacings; the target's planes are no better

  void
  mergeSegments (const std::vector<PointPull>& pulls)
  {
    std::vector<RigidMoments> moments (segments_.size());
    for (int i = 0; i < source_.size(); ++i)
      moments[segments_.label[i]].add (source_.points[i].cast<double>(), pulls[i], 1.0);
    const MergedParts merged = mergeParts (moments, poses_, segments_.links, variance_);
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
      rigid_[p] = sizes[p] >= kRigidShare * source_.size();
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
      const std::vector<float> cost = target_.distances (
          moved, fineRules (2.0 * spacing_), 3.0 * spacing_, threads_);
      for (std::size_t k = 0; k < place.size(); ++k)
        costs[place[k]][c] = cost[k];
    }
    for (int round = 0; round < kSmoothing; ++round)
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
        for (const SurfaceEdge* e = source_.graph.begin (i);
             e != source_.graph.end (i);
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
    const std::vector<PointPull> pulls =
        target_.pulls (moved, fineRules (spacing_), threads_);
    moments_.assign (part_poses_.size(), {});
    for (int i = 0; i < source_.size(); ++i)
      moments_[part_[i]].add (source_.points[i].cast<double>(), pulls[i], 1.0);
    for (std::size_t p = 0; p < part_poses_.size(); ++p)
      if (rigid_[p])
        part_poses_[p] = moments_[p].solve (part_poses_[p]);
    for (int k = 0; k < segments_.size(); ++k)
      if (rigid_[part_of_[k]])
        poses_[k] = part_poses_[part_of_[k]];
  }
  BodyParts
  result ()
  {
    if (part_.empty()) {
      part_ = segments_.label;
      part_poses_ = poses_;
      moments_.assign (poses_.size(), {});
    }
    BodyParts parts;
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
  int threads_;
  std::vector<RigidPose> poses_;      ///< per segment
  PointSamples all_;                  ///< the working points
  double variance_{1.0};
  std::vector<int> part_of_;          ///< per segment
  std::vector<RigidPose> part_poses_; ///< per part
  std::vector<RigidMoments> moments_; ///< per part
  std::vector<char> rigid_;           ///< per part
  std::vector<int> part_;             ///< per working point
};

} // namespace

BodyParts
findParts (const PointClouds& clouds, PointSolve& solve, bool merge, int threads)
{
  return PartFinder (clouds, solve, threads).run (merge);
}

} // namespace pcl_msf
