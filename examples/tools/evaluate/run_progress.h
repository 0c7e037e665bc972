// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace pcl_msf::tool {

/** \brief Tells on stderr how far a run is and how long it will take: on a terminal in
 * one line that is erased at the end, elsewhere in a line now and then. */
class RunProgress {
public:
  /** \param todo pairs to do \param wanted false = say nothing */
  RunProgress (std::size_t todo, bool wanted);
  ~RunProgress();
  RunProgress (const RunProgress&) = delete;
  RunProgress&
  operator= (const RunProgress&) = delete;

  /** \brief One more is done. */
  void
  step (const std::string& name);

  /** \brief Removes the line, for a message. */
  void
  clear () const;

private:
  using Clock = std::chrono::steady_clock;

  std::size_t todo_;
  std::size_t done_{0};
  bool wanted_;
  bool terminal_;
  Clock::time_point start_{Clock::now()};
  Clock::time_point last_{start_};
};

/** \brief "45 s", "12 min", "3 h 05 min" */
std::string
durationText (double seconds);

} // namespace pcl_msf::tool
