// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/disjoint_sets.h"

#include <algorithm>
#include <optional>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief Agglomerative merging: which parts are linked, and which pair of parts to
 * merge next, the cheapest one, ties by number. A merged part has the lower of both
 * numbers. */
class MergeQueue {
public:
  explicit MergeQueue (int parts)
  : sets_ (parts), neighbors_ (parts), version_ (parts, 0)
  {}

  void
  link (int a, int b)
  {
    neighbors_[a].insert (b);
    neighbors_[b].insert (a);
  }
  const std::set<int>&
  neighbors (int part) const
  {
    return neighbors_[part];
  }

  /** \brief Offers a merge, which holds until one of both merges with another part. */
  void
  offer (double cost, int a, int b)
  {
    const auto [first, second] = std::minmax (a, b);
    offers_.push ({cost, first, second, version_[first], version_[second]});
  }

  /** \brief Is there an offer, which may hold no more? */
  bool
  empty () const
  {
    return offers_.empty();
  }

  /** \brief Takes the cheapest offer that holds. \return the lower number first */
  std::optional<std::pair<int, int>>
  next ()
  {
    while (!offers_.empty()) {
      const Offer offer = offers_.top();
      offers_.pop();
      if (version_[offer.first] == offer.first_version &&
          version_[offer.second] == offer.second_version)
        return std::pair (offer.first, offer.second);
    }
    return std::nullopt;
  }

  /** \brief The second part goes into the first, which takes its links. \param second
   * the higher number */
  void
  merge (int first, int second)
  {
    sets_.join (first, second);
    ++version_[first];
    version_[second] = kGone;
    for (const int n : neighbors_[second]) {
      neighbors_[n].erase (second);
      if (n != first)
        link (first, n);
    }
  }

  /** \brief The part that a part went into, itself when it has not. */
  int
  partOf (int part)
  {
    return sets_.root (part);
  }
  bool
  isLeft (int part) const
  {
    return version_[part] != kGone;
  }
  /** \brief Has another part gone into this one, which is left? */
  bool
  hasGrown (int part) const
  {
    return version_[part] > 0;
  }

private:
  static constexpr int kGone = -1;

  struct Offer {
    double cost;
    int first, second;
    int first_version, second_version;
    bool
    operator<(const Offer& other) const // the cheapest on top
    {
      return std::tie (cost, first, second) >
             std::tie (other.cost, other.first, other.second);
    }
  };

  DisjointSets sets_;
  std::vector<std::set<int>> neighbors_;
  std::vector<int> version_; ///< how many parts have gone into each
  std::priority_queue<Offer> offers_;
};

} // namespace pcl_msf
