// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "measure.h"

#include <opencv2/core/utility.hpp>

#include "common/methods/peak_memory.h"
#include "core/base/order_statistics.h"
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>

namespace pcl_msf::benchmarks {

namespace {

using Stage = double tool::StageSeconds::*;
constexpr Stage kStages[] = {&tool::StageSeconds::total,
                             &tool::StageSeconds::frame,
                             &tool::StageSeconds::segment,
                             &tool::StageSeconds::start,
                             &tool::StageSeconds::solve,
                             &tool::StageSeconds::result};

/** Resident megabytes of this process. */
double
residentMegabytes ()
{
  std::ifstream status ("/proc/self/status");
  for (std::string line; std::getline (status, line);)
    if (line.rfind ("VmRSS:", 0) == 0)
      return std::strtod (line.c_str() + 6, nullptr) / 1024.0;
  return std::numeric_limits<double>::quiet_NaN();
}

/** What a run adds to a process of its own that holds the images and libraries. */
double
peakMegabytes (const tool::PairData& pair, const std::string& name)
{
  int pipe_ends[2];
  double megabytes = std::numeric_limits<double>::quiet_NaN();
  if (pipe (pipe_ends) != 0)
    return megabytes;
  const pid_t child = fork();
  if (child == 0) {
    cv::setNumThreads (1);
    malloc_trim (0); // what this process inherits and does not use
    const double before = residentMegabytes();
    const tool::PeakMemory peak;
    tool::makeMethod (name, 1)->run (pair);
    megabytes = peak.megabytes() - before;
    const bool told =
        write (pipe_ends[1], &megabytes, sizeof megabytes) == sizeof megabytes;
    _exit (told ? 0 : 1);
  }
  close (pipe_ends[1]);
  double read_back = 0.0;
  if (child > 0 && read (pipe_ends[0], &read_back, sizeof read_back) ==
                       static_cast<ssize_t> (sizeof read_back))
    megabytes = read_back;
  close (pipe_ends[0]);
  if (child > 0)
    waitpid (child, nullptr, 0);
  return megabytes;
}

/** A method and all that its runs took. */
struct Candidate {
  Measured result;
  std::unique_ptr<tool::Method> method;
  std::vector<tool::StageSeconds> runs;
  double spent{0.0};

  void
  runOnce (const tool::PairData& pair)
  {
    cv::setNumThreads (static_cast<int> (result.threads));
    runs.push_back (method->run (pair).seconds);
    spent += runs.back().total;
  }

  Measured
  medians () const
  {
    Measured measured = result;
    measured.runs = static_cast<int> (runs.size());
    for (const Stage stage : kStages) {
      std::vector<double> values;
      for (const tool::StageSeconds& run : runs)
        values.push_back (run.*stage);
      measured.seconds.*stage = median (values);
    }
    return measured;
  }
};

std::vector<Candidate>
candidates (const tool::PairData& pair, const MeasureOptions& options)
{
  const bool color = !pair.reference.color.empty() && !pair.current.color.empty();
  std::vector<Candidate> all;
  for (const std::string& name : options.methods) {
    auto probe = tool::makeMethod (name, 1);
    if ((probe->needsColor() && !color) || !probe->canRun (pair))
      continue;
    const double megabytes = peakMegabytes (pair, name);
    for (const unsigned threads : options.threads)
      all.push_back ({{name, threads, 0, {}, megabytes},
                      tool::makeMethod (name, threads),
                      {},
                      0.0});
  }
  return all;
}

} // namespace

std::vector<Measured>
measure (const tool::PairData& pair, const MeasureOptions& options)
{
  std::vector<Candidate> all = candidates (pair, options);
  for (int round = 0; round < options.repetitions; ++round)
    for (Candidate& candidate : all)
      if (round == 0 || candidate.spent < options.most_seconds)
        candidate.runOnce (pair);
  std::vector<Measured> measured;
  for (const Candidate& candidate : all)
    measured.push_back (candidate.medians());
  return measured;
}

} // namespace pcl_msf::benchmarks
