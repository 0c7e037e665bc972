// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/stream_tracker.h"

#include <deque>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief The value that a share of all does not exceed: the nearest rank; 0 of none.
 * \param share (0, 1] */
double
percentile (std::vector<double> values, double share);

/** \brief Counts what became of a stream's frames. */
class StreamStatistics {
public:
  void
  add (const StreamResult& result);

  /** \brief Of frames that no result is of. */
  void
  setDropped (long frames)
  {
    dropped_ = frames;
  }

  long
  tracked () const
  {
    return tracked_;
  }
  long
  lost () const
  {
    return lost_;
  }

  /** \brief The result added last, for people: one line without an end. */
  std::string
  line (const StreamResult& result) const;

  /** \brief All of it, for people: one line without an end. */
  std::string
  summary () const;

  /** \brief The same as JSON text. \param source what was played */
  std::string
  json (const std::string& source, bool interrupted) const;

private:
  double
  rate () const;
  double
  presentRate () const;

  long tracked_{0};
  long lost_{0};
  long dropped_{0};
  std::vector<double> latencies_; ///< of tracked frames with motion, seconds
  StreamClock::time_point
      start_; ///< of the second frame's solve, as the first one's end
  StreamClock::time_point end_;
  std::deque<StreamClock::time_point> recent_; ///< results of the last second
};

} // namespace pcl_msf::tool
