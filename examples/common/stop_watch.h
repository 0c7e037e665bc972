// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <chrono>

namespace pcl_msf::tool {

/** \brief Seconds since it was made, or since the last lap. */
class StopWatch {
public:
  double
  lap ()
  {
    const auto now = Clock::now();
    const std::chrono::duration<double> seconds = now - last_;
    last_ = now;
    return seconds.count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_{Clock::now()};
};

} // namespace pcl_msf::tool
