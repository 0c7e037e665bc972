// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <vector>

namespace pcl_msf {

/** \brief The pairs of frames of a window: Z of Eq. 13, each unordered pair once.
 *
 * A pair leads away from the reference, so that its first frame's points are segments
 * carried there; with frames on both sides of the reference it leads forward in time.
 * Frames are in the order of time.
 */
class FramePairs {
public:
  struct Pair {
    int from;
    int to;
    bool adjacent; ///< neighbours in time
  };

  /** \brief A step of a chain of adjacent pairs. */
  struct Step {
    int pair;
    bool inverse; ///< walked from its second frame to its first
  };

  FramePairs (int frames, int reference);

  int
  frames () const
  {
    return frames_;
  }
  int
  reference () const
  {
    return reference_;
  }
  int
  count () const
  {
    return static_cast<int> (pairs_.size());
  }
  const Pair&
  operator[] (int pair) const
  {
    return pairs_[pair];
  }
  const std::vector<Pair>&
  all () const
  {
    return pairs_;
  }

  /** \brief Index of the pair that leads between two frames, in either direction. */
  int
  between (int a, int b) const
  {
    return index_[a * frames_ + b];
  }

  /** \brief Index of the pair from the reference to a frame. */
  int
  fromReference (int frame) const
  {
    return between (reference_, frame);
  }

  /** \brief Adjacent pairs that lead from a pair's first frame to its second
   * (Eq. 14). */
  std::vector<Step>
  chain (int pair) const;

  /** \brief Frames in the order in which motion spreads from the reference: it first,
   * then those after it, then those before it. */
  std::vector<int>
  outwards () const;

private:
  int frames_;
  int reference_;
  std::vector<Pair> pairs_;
  std::vector<int> index_;
};

} // namespace pcl_msf
