// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/part_merging.h"

#include "core/base/merge_queue.h"

#include <algorithm>

namespace pcl_msf {

namespace {

/** A part as one target pulls at it. */
struct PulledPart {
  RigidMoments moments;
  RigidPose pose;
  double minimum{0.0};
};

/** Per target. */
using Part = std::vector<PulledPart>;

class Merger {
public:
  Merger (const std::vector<MergeView>& views,
          const std::vector<SegmentLink>& links,
          const PointPartTuning& tuning)
  : views_ (views)
  , tuning_ (tuning)
  , parts_ (views[0].moments.size(), Part (views.size()))
  , queue_ (static_cast<int> (parts_.size()))
  {
    for (std::size_t k = 0; k < parts_.size(); ++k)
      for (std::size_t v = 0; v < views.size(); ++v) {
        PulledPart& part = parts_[k][v];
        part.moments = views[v].moments[k];
        part.pose = part.moments.solve (views[v].poses[k]);
        part.minimum = part.moments.cost (part.pose);
      }
    for (const SegmentLink& link : links)
      queue_.link (link.first, link.second);
    for (const SegmentLink& link : links)
      consider (link.first, link.second);
  }

  void
  run ()
  {
    while (const auto pair = queue_.next())
      merge (pair->first, pair->second);
  }

  MergedParts
  result ()
  {
    MergedParts merged;
    merged.poses.resize (views_.size());
    std::vector<int> number (parts_.size(), -1);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const int p = queue_.partOf (static_cast<int> (k));
      if (number[p] < 0) {
        number[p] = static_cast<int> (merged.poses[0].size());
        for (std::size_t v = 0; v < views_.size(); ++v)
          merged.poses[v].push_back (parts_[p][v].pose);
      }
      merged.part_of.push_back (number[p]);
    }
    return merged;
  }

private:
  static const PulledPart&
  larger (const PulledPart& a, const PulledPart& b)
  {
    return a.moments.weight() >= b.moments.weight() ? a : b;
  }
  /** What one pose for both costs in a target over what is allowed. */
  double
  excess (const PulledPart& a, const PulledPart& b, double variance) const
  {
    RigidMoments both = a.moments;
    both.add (b.moments);
    const RigidPose pose = both.solve (larger (a, b).pose);
    const double increase = both.cost (pose) - a.minimum - b.minimum;
    const double points = std::min (a.moments.weight(), b.moments.weight());
    return increase / variance - tuning_.allowance - tuning_.per_point * points;
  }
  void
  consider (int first, int second)
  {
    const int a = std::min (first, second);
    const int b = std::max (first, second);
    double most = excess (parts_[a][0], parts_[b][0], views_[0].variance);
    for (std::size_t v = 1; v < views_.size() && most < 0.0; ++v)
      most = std::max (most, excess (parts_[a][v], parts_[b][v], views_[v].variance));
    if (most < 0.0)
      queue_.offer (most, a, b);
  }
  void
  merge (int a, int b)
  {
    for (std::size_t v = 0; v < views_.size(); ++v) {
      PulledPart& to = parts_[a][v];
      const PulledPart& from = parts_[b][v];
      const RigidPose start = larger (to, from).pose;
      to.moments.add (from.moments);
      to.pose = to.moments.solve (start);
      to.minimum = to.moments.cost (to.pose);
    }
    queue_.merge (a, b);
    for (const int n : queue_.neighbors (a))
      consider (a, n);
  }

  const std::vector<MergeView>& views_;
  const PointPartTuning& tuning_;
  std::vector<Part> parts_;
  MergeQueue queue_; ///< by the increase over what is allowed
};

} // namespace

MergedParts
mergeParts (const std::vector<MergeView>& views,
            const std::vector<SegmentLink>& links,
            const PointPartTuning& tuning)
{
  Merger merger (views, links, tuning);
  merger.run();
  return merger.result();
}

} // namespace pcl_msf
