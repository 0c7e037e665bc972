// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// Scores our method and baselines on data sets, recorded or generated.
#include "common/tool_main.h"
#include "csv.h"
#include "merge.h"
#include "options.h"
#include "run.h"
#include "summary.h"
#include "tables.h"
#include <pcl_msf/io/text_files.h>

#include <cstdio>

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
    complain (kProgram,
              "missing: " + missing +
                  "; run these shards again, or without --shard on the merged --csv");
  return missing.empty() ? 0 : 1;
}

int
run (const EvaluateOptions& options)
{
  if (options.merge)
    return merge (options);
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
      {kProgram, parseEvaluateOptions, printEvaluateHelp, run}, argc, argv);
}
