// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/parameters.h>
#include <pcl_msf/scene_flow.h>

#include <chrono>

namespace pcl_msf {

/** \brief Counts a solve's steps, tells the user's callback of them, and says when it
 * has to stop. */
class SolveProgress {
public:
  /** \param steps about how many there will be */
  SolveProgress (const SolverParameters& solver, int steps)
  : solver_ (solver), steps_ (steps), begin_ (std::chrono::steady_clock::now())
  {}

  /** \brief After a step. \return may the solve go on? */
  bool
  note (int level, double cost, const char* stage);

  /** \brief Tells the callback, once the results are there, that all is done; not one
   * that has cancelled. */
  void
  finish () const;

  bool
  stopped () const
  {
    return reason_ != StopReason::NotRun;
  }
  StopReason
  reason () const
  {
    return reason_;
  }
  int
  iterations () const
  {
    return static_cast<int> (history_.size());
  }
  const std::vector<IterationRecord>&
  history () const
  {
    return history_;
  }
  double
  seconds () const;

private:
  Progress
  present () const;

  const SolverParameters& solver_;
  int steps_;
  std::chrono::steady_clock::time_point begin_;
  StopReason reason_{StopReason::NotRun};
  std::vector<IterationRecord> history_;
};

} // namespace pcl_msf
