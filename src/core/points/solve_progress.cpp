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
  Progress progress = present();
  progress.fraction = std::min (1.0, static_cast<double> (iterations()) / steps_);
  progress.stage = stage;
  if (!solver_.progress (progress) && !stopped())
    reason_ = StopReason::Cancelled;
  return !stopped();
}

Progress
SolveProgress::present() const
{
  Progress progress;
  progress.iteration = iterations();
  if (!history_.empty()) {
    progress.level = history_.back().level;
    progress.cost = history_.back().cost;
  }
  return progress;
}

void
SolveProgress::finish() const
{
  if (!solver_.progress || reason_ == StopReason::Cancelled)
    return;
  Progress progress = present();
  progress.fraction = 1.0;
  progress.stage = "result";
  solver_.progress (progress); // nothing is left to cancel
}

} // namespace pcl_msf
