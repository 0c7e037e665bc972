// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "run.h"

#include <opencv2/core/utility.hpp>

#include "common/interruption.h"
#include "result_store.h"
#include "run_progress.h"
#include "work.h"
#include "worker_pool.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <thread>

namespace pcl_msf::tool {

namespace {

/** Several processes share the machine's cores. */
EvaluateOptions
shareCores (EvaluateOptions options)
{
  if (options.threads == 0 && options.jobs > 1)
    options.threads = std::max (
        1U, std::thread::hardware_concurrency() / static_cast<unsigned> (options.jobs));
  options.generated.threads = options.threads;
  return options;
}

std::string
nameOf (const WorkItem& item)
{
  return item.name + " " + std::to_string (item.from) + "-" + std::to_string (item.to);
}

std::vector<Row>
rowsFrom (const std::string& text)
{
  std::vector<Row> rows;
  std::istringstream stream (text);
  for (std::string line; std::getline (stream, line);)
    rows.push_back (parseRow (line));
  return rows;
}

/** Made in the process that does the work. */
std::string
runPair (const EvaluateOptions& options, const WorkItem& item)
{
  if (options.threads > 0)
    cv::setNumThreads (
        std::min (static_cast<int> (options.threads), cv::getNumberOfCPUs()));
  std::string text;
  for (const Row& row : PairRunner (options).run (item))
    text += rowText (row);
  return text;
}

} // namespace

RunOutcome
evaluateAll (const EvaluateOptions& given)
{
  const EvaluateOptions options = shareCores (given);
  const std::vector<WorkItem> work = listWork (options);
  ResultStore store (
      options.csv,
      {PCL_MSF_VERSION, options.settings(), options.shard, work.size(), {}},
      work,
      options.methods);
  std::vector<std::size_t> todo;
  for (const WorkItem& item : work)
    if (options.shard.has (item.number) && !store.has (item.number))
      todo.push_back (item.number);
  RunProgress progress (todo.size(), !options.quiet);
  RunOutcome outcome;
  runInProcesses (
      options.jobs,
      todo,
      [&] (std::size_t i) { return runPair (options, work[i]); },
      [&] (const WorkResult& result) {
        const std::string name = nameOf (work[result.item]);
        if (result.failed) {
          ++outcome.failed;
          progress.clear();
          std::fprintf (
              stderr, "pcl_msf_evaluate: %s: %s\n", name.c_str(), result.text.c_str());
        }
        else
          store.add (rowsFrom (result.text));
        progress.step (name);
        return !interrupted();
      });
  outcome.results = store.finish();
  throwIfInterrupted();
  return outcome;
}

} // namespace pcl_msf::tool
