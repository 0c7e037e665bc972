// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/energy/solve_monitor.h"

#include <algorithm>

namespace pcl_msf {

double
SolveMonitor::secondsLeft() const
{
  constexpr double kForever = 1e9;
  return parameters_.max_seconds > 0.0
             ? std::max (0.0, parameters_.max_seconds - seconds())
             : kForever;
}

void
SolveMonitor::enter (const char* stage, int level, double begin, double end, int steps)
{
  progress_.stage = stage;
  progress_.level = level;
  begin_ = begin;
  end_ = end;
  steps_ = std::max (1, steps);
  done_ = 0;
  ++energy_;
}

bool
SolveMonitor::step (double cost)
{
  ++iterations_;
  done_ = std::min (done_ + 1, steps_);
  history_.push_back ({progress_.level, cost, seconds(), terms_, energy_});
  progress_.iteration = iterations_;
  progress_.fraction = begin_ + (end_ - begin_) * done_ / steps_;
  progress_.cost = cost;
  if (reason_ == StopReason::NotRun && parameters_.progress &&
      !parameters_.progress (progress_))
    reason_ = StopReason::Cancelled;
  return !stopped();
}

bool
SolveMonitor::stopped()
{
  if (reason_ == StopReason::NotRun && secondsLeft() <= 0.0)
    reason_ = StopReason::TimeLimit;
  return reason_ != StopReason::NotRun;
}

} // namespace pcl_msf
