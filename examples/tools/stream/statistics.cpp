// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "stream/statistics.h"

#include "core/base/number_text.h"
#include "core/base/order_statistics.h"
#include "io/base/json.h"

#include <algorithm>
#include <cmath>

namespace pcl_msf::tool {

namespace {

constexpr double kMilliseconds = 1000.0;

double
secondsBetween (StreamClock::time_point begin, StreamClock::time_point end)
{
  return std::chrono::duration<double> (end - begin).count();
}

/** Results a second, of the times between them. */
double
rateOf (long intervals, double seconds)
{
  return seconds > 0.0 ? static_cast<double> (intervals) / seconds : 0.0;
}

std::string
millisecondsText (double seconds)
{
  return fixedText (kMilliseconds * seconds, 1) + " ms";
}

} // namespace

double
percentile (std::vector<double> values, double share)
{
  if (values.empty())
    return 0.0;
  const double rank = std::ceil (share * static_cast<double> (values.size()));
  return nthSmallest (values, static_cast<std::size_t> (std::max (rank, 1.0)) - 1);
}

void
StreamStatistics::add (const StreamResult& result)
{
  end_ = StreamClock::now();
  if (tracked_ + lost_ == 0)
    start_ = end_;
  ++(result.problem.empty() ? tracked_ : lost_);
  if (result.problem.empty() && !result.first)
    latencies_.push_back (result.latency);
  recent_.push_back (end_);
  while (recent_.size() > 2 && secondsBetween (recent_.front(), end_) > 1.0)
    recent_.pop_front();
}

double
StreamStatistics::rate() const
{
  return rateOf (tracked_ + lost_ - 1, secondsBetween (start_, end_));
}

double
StreamStatistics::presentRate() const
{
  return rateOf (static_cast<long> (recent_.size()) - 1,
                 secondsBetween (recent_.front(), end_));
}

std::string
StreamStatistics::line (const StreamResult& result) const
{
  const std::string frame = "frame " + std::to_string (result.index) + ": ";
  if (result.first)
    return frame + "the first one";
  return frame + fixedText (presentRate(), 1) + " Hz, latency " +
         millisecondsText (result.latency) + ", " + std::to_string (dropped_) +
         " dropped, " + std::to_string (lost_) + " lost, " +
         std::to_string (result.groups) +
         " motion groups, dominant motion since frame " +
         std::to_string (result.reference) + ": " + fixedText (result.metres, 4) +
         " m, " + fixedText (result.degrees, 3) + " deg";
}

std::string
StreamStatistics::summary() const
{
  return std::to_string (tracked_ + lost_ + dropped_) +
         " frames: " + std::to_string (tracked_) + " tracked, " +
         std::to_string (lost_) + " lost, " + std::to_string (dropped_) + " dropped; " +
         fixedText (rate(), 1) + " Hz, latency " +
         millisecondsText (percentile (latencies_, 0.5)) + " (median), " +
         millisecondsText (percentile (latencies_, 0.99)) + " (99th percentile)";
}

std::string
StreamStatistics::json (const std::string& source, bool interrupted) const
{
  return io::jsonText (
      {{"source", source},
       {"interrupted", interrupted},
       {"frames", tracked_ + lost_ + dropped_},
       {"tracked", tracked_},
       {"lost", lost_},
       {"dropped", dropped_},
       {"seconds", secondsBetween (start_, end_)},
       {"frames_per_second", rate()},
       {"latency_ms",
        {{"median", kMilliseconds * percentile (latencies_, 0.5)},
         {"percentile_99", kMilliseconds * percentile (latencies_, 0.99)},
         {"largest", kMilliseconds * percentile (latencies_, 1.0)}}}});
}

} // namespace pcl_msf::tool
