// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Scores our method and baselines on data sets, recorded or generated.
#include "cloud_run.h"
#include "cloud_table.h"
#include "common/command_line.h"
#include "common/input_files.h"
#include "common/tool_main.h"
#include "merge.h"
#include "options.h"
#include "pair_table.h"
#include "result_store.h"
#include "run.h"
#include "summary.h"
#include "tables.h"
#include <pcl_msf/io/text_files.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace {

using namespace pcl_msf;
using namespace pcl_msf::tool;

constexpr const char* kProgram = "pcl_msf_evaluate";

void
report (const ResultFile& results, const EvaluateOptions& options)
{
  if (!options.json.empty())
    io::writeText (options.json, jsonText (results));
  if (!results.rows.empty())
    std::fputs (allTables (results.rows).c_str(), stdout);
}

/** Before the work: neither output may be an input, or somebody else's file. */
void
checkOutputs (const EvaluateOptions& options)
{
  InputFiles shards;
  for (const std::string& path : options.merged)
    shards.add (path);
  requireNoInput ("--csv", options.csv, shards);
  requireNoInput ("--json", options.json, shards);
  InputFiles table;
  table.add (options.csv);
  requireNoInput ("--json", options.json, table);
  if (!options.json.empty() && options.json == options.csv)
    throw UsageError ("--json: '" + options.json +
                      "' is the --csv, too; give two names");
  std::ifstream stream (options.json, std::ios::binary);
  std::string begin (64, '\0');
  if (stream && (stream.read (begin.data(), 64), !isResultsJson (begin)))
    throw UsageError ("--json: '" + options.json +
                      "' is there and no result of this tool; give another name");
}

/** A table that is there may be replaced by one that holds as much of the same run. */
void
requireNoLoss (const std::string& csv, const ResultFile& merged)
{
  if (csv.empty() || !std::filesystem::exists (csv))
    return;
  const ResultFile found = readResults (csv);
  requireSameRun (csv, found, merged);
  if (found.rows.size() > merged.rows.size())
    throw UsageError (csv + ": holds " + std::to_string (found.rows.size()) +
                      " rows, the shards " + std::to_string (merged.rows.size()) +
                      "; give another --csv, or remove the file");
}

int
merge (const EvaluateOptions& options)
{
  const Merged merged = mergeResults (options.merged);
  requireNoLoss (options.csv, merged.results);
  if (!options.csv.empty())
    writeResults (options.csv, merged.results);
  report (merged.results, options);
  std::string missing;
  for (const std::string& what : merged.missing)
    missing += (missing.empty() ? "" : "; ") + what;
  if (!missing.empty())
    complain (kProgram,
              "missing: " + missing +
                  "; run these shards again, or without --shard on the merged --csv");
  return missing.empty() ? 0 : 1;
}

int
run (const EvaluateOptions& options)
{
  checkOutputs (options);
  if (options.merge)
    return isCloudCsv (options.merged.front()) ? mergeCloudShards (options)
                                               : merge (options);
  if (isOfClouds (options))
    return evaluateClouds (options);
  const RunOutcome outcome = evaluateAll (options);
  report (outcome.results, options);
  if (outcome.failed > 0)
    complain (kProgram,
              std::to_string (outcome.failed) +
                  " pairs failed; the same command tries them again");
  return outcome.failed > 0 ? 1 : 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return toolMain<EvaluateOptions> (
      {kProgram, kSummary, declareOptions, run}, argc, argv);
}
