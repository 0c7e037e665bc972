// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Scores our method and baselines on data sets, recorded or generated.
#include <pcl/console/print.h>

#include <opencv2/core/utils/logger.hpp>

#include "csv.h"
#include "merge.h"
#include "options.h"
#include "run.h"
#include "scene_flow/interruption.h"
#include "scene_flow/options.h"
#include "summary.h"
#include "tables.h"
#include <pcl_msf/io/text_files.h>

#include <algorithm>
#include <cstdio>
#include <exception>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_evaluate";

/** One line on stderr, whatever the message holds. */
void
complain (std::string message)
{
  std::replace (message.begin(), message.end(), '\n', ' ');
  std::fprintf (stderr, "%s: %s\n", kProgram, message.c_str());
}

void
report (const ResultFile& results, const EvaluateOptions& options)
{
  if (!options.json.empty())
    io::writeText (options.json, jsonText (results));
  if (!results.rows.empty())
    std::fputs (allTables (results.rows).c_str(), stdout);
}

int
merge (const EvaluateOptions& options)
{
  const Merged merged = mergeResults (options.merged);
  if (!options.csv.empty())
    writeResults (options.csv, merged.results);
  report (merged.results, options);
  std::string missing;
  for (const std::string& what : merged.missing)
    missing += (missing.empty() ? "" : "; ") + what;
  if (!missing.empty())
    complain ("missing: " + missing +
              "; run these shards again, or without --shard on the merged --csv");
  return missing.empty() ? 0 : 1;
}

int
run (const EvaluateOptions& options)
{
  const RunOutcome outcome = evaluateAll (options);
  report (outcome.results, options);
  if (outcome.failed > 0)
    complain (std::to_string (outcome.failed) +
              " pairs failed; the same command tries them again");
  return outcome.failed > 0 ? 1 : 0;
}

} // namespace

int
main (int argc, char** argv)
{
  cv::utils::logging::setLogLevel (cv::utils::logging::LOG_LEVEL_SILENT);
  try {
    if (argc < 2) {
      printEvaluateHelp (kProgram);
      return 1;
    }
    const EvaluateOptions options = parseEvaluateOptions (argc, argv);
    if (options.help) {
      printEvaluateHelp (kProgram);
      return 0;
    }
    pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
    noteSignals();
    return options.merge ? merge (options) : run (options);
  }
  catch (const Interrupted& e) {
    complain (e.what());
    return interruptedStatus();
  }
  catch (const std::exception& e) {
    complain (e.what());
    return 1;
  }
}
