// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/parameters.h>
#include <pcl_msf/scene_flow.h>

#include <chrono>
#include <vector>

namespace pcl_msf {

/** \brief Clock, iteration count, time budget and cancellation of one registration. */
class SolveMonitor {
public:
  explicit SolveMonitor (const SolverParameters& parameters)
  : parameters_ (parameters), start_ (std::chrono::steady_clock::now())
  {}

  /** \brief Seconds since construction. */
  double
  seconds () const
  {
    return std::chrono::duration<double> (std::chrono::steady_clock::now() - start_)
        .count();
  }

  /** \brief Seconds left of the budget; a very large number without one. */
  double
  secondsLeft () const;

  /** \brief Enters a stage, with an energy of its own, that takes the work from `begin`
   * to `end`, shares of 1. */
  void
  enter (const char* stage, int level, double begin, double end, int steps);

  /** \brief One step done: tells the progress callback. \return go on? */
  bool
  step (double cost);

  /** \brief Energy by term that the next steps are recorded with. */
  void
  noteTerms (const EnergyCost& terms)
  {
    terms_ = terms;
  }

  /** \brief True once cancelled or out of time. */
  bool
  stopped ();

  StopReason
  stopReason () const
  {
    return reason_;
  }
  int
  iterations () const
  {
    return iterations_;
  }
  const std::vector<IterationRecord>&
  history () const
  {
    return history_;
  }

private:
  const SolverParameters& parameters_;
  std::chrono::steady_clock::time_point start_;
  Progress progress_;
  double begin_{0.0};
  double end_{0.0};
  int steps_{1};
  int done_{0};
  int iterations_{0};
  int energy_{-1}; // of the present stage; the first has 0
  EnergyCost terms_;
  StopReason reason_{StopReason::NotRun};
  std::vector<IterationRecord> history_;
};

} // namespace pcl_msf
