// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/solve_progress.h"

#include <algorithm>

namespace pcl_msf {

double
SolveProgress::seconds() const
{
  const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin_;
  return gone.count();
}

bool
SolveProgress::note (int level, double cost, const char* stage)
{
  IterationRecord record;
  record.level = level;
  record.cost = cost;
  record.seconds = seconds();
  history_.push_back (record);
  if (solver_.max_seconds > 0.0 && record.seconds > solver_.max_seconds)
    reason_ = StopReason::TimeLimit;
  if (!solver_.progress)
    return !stopped();
  Progress progress;
  progress.level = level;
  progress.iteration = iterations();
  progress.fraction = std::min (1.0, static_cast<double> (iterations()) / steps_);
  progress.cost = cost;
  progress.stage = stage;
  if (!solver_.progress (progress) && !stopped())
    reason_ = StopReason::Cancelled;
  return !stopped();
}

} // namespace pcl_msf
