// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/rigid_parts.h"

#include "core/points/part_view.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace pcl_msf {

namespace {

class PartFinder {
public:
  PartFinder (const std::vector<PointFrame>& frames,
              const PointTuning& tuning,
              int threads)
  : source_ (frames[0].clouds.source.surface)
  , segments_ (frames[0].solve->segments())
  , tuning_ (tuning.parts)
  , threads_ (threads)
  {
    views_.reserve (frames.size());
    for (const PointFrame& frame : frames)
      views_.emplace_back (frame, tuning, threads);
    labels_.part_of.resize (segments_.size());
    std::iota (labels_.part_of.begin(), labels_.part_of.end(), 0);
    for (PartView& view : views_)
      view.takeSegments();
  }

  std::vector<RigidParts>
  run (bool merge)
  {
    labels_.part = segments_.label;
    if (merge || segments_.given) {
      if (merge)
        mergeSegments();
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
  mergeSegments ()
  {
    std::vector<SegmentLink> links;
    for (const SegmentLink& link : segments_.links)
      if (!segments_.isFixed (link.first) && !segments_.isFixed (link.second))
        links.push_back (link);
    std::vector<MergeView> views;
    for (const PartView& view : views_)
      views.push_back (view.mergeView());
    MergedParts merged = mergeParts (views, links, tuning_);
    labels_.part_of = merged.part_of;
    for (std::size_t v = 0; v < views_.size(); ++v) {
      views_[v].take (std::move (merged.poses[v]));
      for (int k = 0; k < segments_.size(); ++k)
        if (segments_.isFixed (k))
          views_[v].setPartPose (labels_.part_of[k], views_[v].segmentPose (k));
    }
  }
  int
  parts () const
  {
    return 1 + *std::max_element (labels_.part_of.begin(), labels_.part_of.end());
  }
  /** Which parts are rigid bodies, and which of these are fitted on their own: small
   * ones keep what their neighbours told them. */
  void
  chooseBodies ()
  {
    count_ = parts();
    std::vector<int> sizes (count_, 0);
    for (const int label : segments_.label)
      ++sizes[labels_.part_of[label]];
    labels_.free.assign (count_, 0);
    for (int p = 0; p < count_; ++p)
      labels_.free[p] = sizes[p] >= tuning_.rigid_share * source_.size();
    labels_.rigid = labels_.free;
    if (segments_.given)
      labels_.rigid.assign (count_, 1);
    for (int k = 0; k < segments_.size(); ++k)
      if (segments_.isFixed (k))
        labels_.free[labels_.part_of[k]] = 0;
    for (PartView& view : views_)
      view.followParts (labels_);
  }
  /** Points between parts go with the one whose motion fits them best; given segments
   * stay whole. */
  void
  drawBorders ()
  {
    if (segments_.given)
      for (int& part : labels_.part)
        part = labels_.part_of[part];
    else {
      std::vector<BorderView> views;
      for (PartView& view : views_)
        views.push_back (view.borderView());
      labels_.part = borders().draw (views, tuning_, threads_);
    }
    for (PartView& view : views_)
      for (const KnownPoint& known : view.known()) {
        const int own = labels_.part_of[segments_.label[known.place]];
        int& drawn = labels_.part[known.place];
        if (labels_.rigid[own] && labels_.rigid[drawn] &&
            view.pairCost (known, own) < view.pairCost (known, drawn))
          drawn = own;
      }
    for (int i = 0; i < source_.size(); ++i)
      if (labels_.rigid[labels_.part[i]])
        follow (i, borders().oneOf (labels_.part[i]));
  }
  PartBorders
  borders () const
  {
    return {source_, segments_, labels_.part_of, labels_.rigid};
  }
  void
  follow (int point, const std::vector<Membership>& members)
  {
    for (PartView& view : views_)
      view.follow (point, members);
  }
  void
  polish ()
  {
    const BodySeams seams = seamsOfBodies (source_, labels_.part, labels_.rigid);
    if (views_.size() == 1)
      return views_[0].polish (labels_, seams);
    for (PartView& view : views_)
      view.polishWithCare (labels_, seams);
  }
  /** Do known pairs let a part go with another one? */
  bool
  pairsAllow (int part, int other) const
  {
    double cost = 0.0;
    for (const PartView& view : views_)
      cost += view.pairLoss (labels_, part, other);
    return cost <= tuning_.allowance;
  }
  bool
  fixed (int part) const
  {
    const auto& part_of = labels_.part_of;
    const auto k = std::find (part_of.begin(), part_of.end(), part);
    return segments_.isFixed (static_cast<int> (k - part_of.begin()));
  }
  /** Pairs of parts that touch, the smaller one first. */
  std::set<std::pair<int, int>>
  touchingParts (const std::vector<std::vector<int>>& points) const
  {
    std::set<std::pair<int, int>> pairs;
    for (const SurfaceSeam& seam : seamsBetween (source_, labels_.part)) {
      int a = seam.first;
      int b = seam.second;
      if (std::make_pair (points[b].size(), b) < std::make_pair (points[a].size(), a))
        std::swap (a, b);
      if (labels_.rigid[b] && !fixed (a) && !fixed (b) && pairsAllow (a, b))
        pairs.insert ({a, b});
    }
    return pairs;
  }
  /** How far a part is from the targets, in all. \param members of its points in place
   * of their own; empty = their own */
  double
  distanceOf (const std::vector<int>& points, const std::vector<Membership>& members)
  {
    double sum = 0.0;
    for (PartView& view : views_)
      sum += view.distanceOf (points, members);
    return sum;
  }
  /** How far it may be from them with another one's motion. */
  double
  boundOf (const std::vector<int>& points)
  {
    double bound = (1.0 + tuning_.worse_share) * distanceOf (points, {});
    for (const PartView& view : views_)
      bound += tuning_.worse * view.spacing();
    return bound;
  }
  /** Parts that fit the targets as well with a larger body's motion join that body.
   * \return did any? */
  bool
  absorb ()
  {
    std::vector<std::vector<int>> points (count_);
    for (int i = 0; i < source_.size(); ++i)
      points[labels_.part[i]].push_back (i);
    std::vector<int> into (count_, -1);
    std::vector<double> best (count_, 0.0);
    for (const auto& [a, b] : touchingParts (points)) {
      if (into[a] < 0 && best[a] == 0.0)
        best[a] = boundOf (points[a]);
      const double distance = distanceOf (points[a], borders().oneOf (b));
      if (distance < best[a]) {
        best[a] = distance;
        into[a] = b;
      }
    }
    bool any = false;
    for (int a = 0; a < count_; ++a) {
      int b = into[a];
      while (b >= 0 && into[b] >= 0) // larger and larger
        b = into[b];
      if (b < 0)
        continue;
      any = true;
      join (a, b, points[a]);
    }
    return any;
  }
  void
  join (int part, int body, const std::vector<int>& points)
  {
    for (PartView& view : views_)
      view.forgetDistances();
    for (const int i : points) {
      labels_.part[i] = body;
      follow (i, borders().oneOf (body));
    }
    for (int& of : labels_.part_of)
      if (of == part)
        of = body;
  }
  std::vector<RigidParts>
  result ()
  {
    std::vector<int> sizes (count_ > 0 ? count_ : segments_.size(), 0);
    for (const int p : labels_.part)
      ++sizes[p];
    std::vector<int> order (sizes.size());
    std::iota (order.begin(), order.end(), 0);
    std::stable_sort (order.begin(), order.end(), [&sizes] (int a, int b) {
      return sizes[a] > sizes[b];
    });
    while (!order.empty() && sizes[order.back()] == 0)
      order.pop_back();
    std::vector<int> rank (sizes.size(), -1);
    for (std::size_t r = 0; r < order.size(); ++r)
      rank[order[r]] = static_cast<int> (r);
    std::vector<RigidParts> results;
    for (const PartView& view : views_) {
      RigidParts parts;
      for (const int p : order) {
        Matrix6 information;
        parts.poses.push_back (view.poseOf (p, information));
        parts.information.push_back (information);
        parts.sizes.push_back (sizes[p]);
      }
      for (const int p : labels_.part)
        parts.part.push_back (rank[p]);
      MovedPoints moved = view.moved();
      parts.points = std::move (moved.points);
      parts.normals = std::move (moved.normals);
      results.push_back (std::move (parts));
    }
    return results;
  }

  const Surface& source_;
  const SurfaceSegments& segments_;
  const PointPartTuning& tuning_;
  int threads_;
  std::vector<PartView> views_; ///< per target
  PartLabels labels_;
  int count_{0}; ///< parts, with those that have joined others
};

} // namespace

std::vector<RigidParts>
findParts (const std::vector<PointFrame>& frames,
           bool merge,
           const PointTuning& tuning,
           int threads)
{
  return PartFinder (frames, tuning, threads).run (merge);
}

} // namespace pcl_msf
