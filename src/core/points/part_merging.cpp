// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/part_merging.h"

#include "core/base/merge_queue.h"

#include <algorithm>

namespace pcl_msf {

namespace {

struct Part {
  RigidMoments moments;
  RigidPose pose;
  double minimum{0.0};
};

class Merger {
public:
  Merger (const std::vector<RigidMoments>& moments,
          const std::vector<RigidPose>& poses,
          const std::vector<SegmentLink>& links,
          double variance,
          const PointPartTuning& tuning)
  : variance_ (variance)
  , tuning_ (tuning)
  , parts_ (moments.size())
  , queue_ (static_cast<int> (moments.size()))
  {
    for (std::size_t k = 0; k < moments.size(); ++k) {
      parts_[k].moments = moments[k];
      parts_[k].pose = moments[k].solve (poses[k]);
      parts_[k].minimum = moments[k].cost (parts_[k].pose);
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
    std::vector<int> number (parts_.size(), -1);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const int p = queue_.partOf (static_cast<int> (k));
      if (number[p] < 0) {
        number[p] = static_cast<int> (merged.poses.size());
        merged.poses.push_back (parts_[p].pose);
        merged.moments.push_back (parts_[p].moments);
      }
      merged.part_of.push_back (number[p]);
    }
    return merged;
  }

private:
  static RigidMoments
  sum (const Part& a, const Part& b)
  {
    RigidMoments both = a.moments;
    both.add (b.moments);
    return both;
  }
  const Part&
  larger (const Part& a, const Part& b) const
  {
    return a.moments.weight() >= b.moments.weight() ? a : b;
  }
  void
  consider (int first, int second)
  {
    const int a = std::min (first, second);
    const int b = std::max (first, second);
    const RigidMoments both = sum (parts_[a], parts_[b]);
    const RigidPose pose = both.solve (larger (parts_[a], parts_[b]).pose);
    const double increase = both.cost (pose) - parts_[a].minimum - parts_[b].minimum;
    const double points =
        std::min (parts_[a].moments.weight(), parts_[b].moments.weight());
    const double excess =
        increase / variance_ - tuning_.allowance - tuning_.per_point * points;
    if (excess < 0.0)
      queue_.offer (excess, a, b);
  }
  void
  merge (int a, int b)
  {
    Part& to = parts_[a];
    const Part& from = parts_[b];
    const RigidPose start = larger (to, from).pose;
    to.moments.add (from.moments);
    to.pose = to.moments.solve (start);
    to.minimum = to.moments.cost (to.pose);
    queue_.merge (a, b);
    for (const int n : queue_.neighbors (a))
      consider (a, n);
  }

  double variance_;
  const PointPartTuning& tuning_;
  std::vector<Part> parts_;
  MergeQueue queue_; ///< by the increase over what is allowed
};

} // namespace

MergedParts
mergeParts (const std::vector<RigidMoments>& moments,
            const std::vector<RigidPose>& poses,
            const std::vector<SegmentLink>& links,
            double variance,
            const PointPartTuning& tuning)
{
  Merger merger (moments, poses, links, variance, tuning);
  merger.run();
  return merger.result();
}

} // namespace pcl_msf
