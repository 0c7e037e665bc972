// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "run.h"

#include <opencv2/core/utility.hpp>

#include "common/interruption.h"
#include "common/tool_main.h"
#include "result_store.h"
#include "run_progress.h"
#include "work.h"
#include <pcl_msf/version.h>

#include <algorithm>
#include <exception>

namespace pcl_msf::tool {

namespace {

std::string
nameOf (const WorkItem& item)
{
  return item.name + " " + std::to_string (item.from) + "-" + std::to_string (item.to);
}

} // namespace

RunOutcome
evaluateAll (const EvaluateOptions& options)
{
  if (options.threads > 0)
    cv::setNumThreads (
        std::min (static_cast<int> (options.threads), cv::getNumberOfCPUs()));
  const std::vector<WorkItem> work = listWork (options);
  ResultStore store (
      options.csv,
      {PCL_MSF_VERSION_PRETTY, options.settings(), options.shard, work.size(), {}},
      work,
      options.methods);
  std::vector<const WorkItem*> todo;
  for (const WorkItem& item : work)
    if (options.shard.has (item.number) && !store.has (item.number))
      todo.push_back (&item);
  RunProgress progress (todo.size(), !options.quiet);
  PairRunner runner (options);
  RunOutcome outcome;
  for (const WorkItem* item : todo) {
    if (interrupted())
      break;
    const std::string name = nameOf (*item);
    try {
      store.add (runner.run (*item));
    }
    catch (const std::exception& error) {
      ++outcome.failed;
      progress.clear();
      complain ("pcl_msf_evaluate", name + ": " + error.what());
    }
    progress.step (name);
  }
  outcome.results = store.finish();
  throwIfInterrupted();
  return outcome;
}

} // namespace pcl_msf::tool
