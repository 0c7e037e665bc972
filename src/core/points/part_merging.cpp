// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/part_merging.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <set>
#include <tuple>

namespace pcl_msf {

namespace {

struct Part {
  RigidMoments moments;
  RigidPose pose;
  double minimum{0.0};
  int version{0};
  bool alive{true};
  std::set<int> neighbors;
};

struct Offer {
  double excess; ///< of the increase over what is allowed
  int first, second;
  int first_version, second_version;
  bool
  operator<(const Offer& other) const // the cheapest on top, ties by index
  {
    return std::tie (excess, first, second) >
           std::tie (other.excess, other.first, other.second);
  }
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
  , joined_ (moments.size())
  {
    std::iota (joined_.begin(), joined_.end(), 0);
    for (std::size_t k = 0; k < moments.size(); ++k) {
      parts_[k].moments = moments[k];
      parts_[k].pose = moments[k].solve (poses[k]);
      parts_[k].minimum = moments[k].cost (parts_[k].pose);
    }
    for (const SegmentLink& link : links) {
      parts_[link.first].neighbors.insert (link.second);
      parts_[link.second].neighbors.insert (link.first);
    }
    for (const SegmentLink& link : links)
      consider (link.first, link.second);
  }

  void
  run ()
  {
    while (!offers_.empty()) {
      const Offer offer = offers_.top();
      offers_.pop();
      const Part& a = parts_[offer.first];
      const Part& b = parts_[offer.second];
      if (a.alive && b.alive && a.version == offer.first_version &&
          b.version == offer.second_version)
        merge (offer.first, offer.second);
    }
  }

  MergedParts
  result () const
  {
    MergedParts merged;
    std::vector<int> number (parts_.size(), -1);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      int p = static_cast<int> (k);
      while (joined_[p] != p)
        p = joined_[p];
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
      offers_.push ({excess, a, b, parts_[a].version, parts_[b].version});
  }
  void
  merge (int a, int b)
  {
    Part& to = parts_[a];
    Part& from = parts_[b];
    const RigidPose start = larger (to, from).pose;
    to.moments.add (from.moments);
    to.pose = to.moments.solve (start);
    to.minimum = to.moments.cost (to.pose);
    ++to.version;
    from.alive = false;
    joined_[b] = a;
    for (const int n : from.neighbors) {
      parts_[n].neighbors.erase (b);
      if (n != a) {
        parts_[n].neighbors.insert (a);
        to.neighbors.insert (n);
      }
    }
    for (const int n : std::set<int> (to.neighbors))
      consider (a, n);
  }

  double variance_;
  const PointPartTuning& tuning_;
  std::vector<Part> parts_;
  std::vector<int> joined_; ///< the one that a part went into
  std::priority_queue<Offer> offers_;
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
